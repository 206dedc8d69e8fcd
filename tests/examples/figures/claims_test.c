/* SPDX-License-Identifier: MIT */
/* What decides whether a claim holds, and how far an estimate is off */
#include "claims.h"
#include "errors.h"
#include "unity.h"

#include <math.h>

void setUp(void)
{
}

void tearDown(void)
{
}

static const double not_a_number = (double)NAN;

static void test_a_claim_holds_up_to_its_limit_and_not_beyond(void)
{
    claims_t claims = {"9", 0, 0};
    claim_at_most(&claims, 1.0, 1.0, "N", "at the limit");
    claim_at_least(&claims, 1.0, 1.0, "N", "at the limit");
    TEST_ASSERT_TRUE(claims_hold(&claims));
    claim_at_most(&claims, nextafter(1.0, 2.0), 1.0, "N", "above its limit");
    TEST_ASSERT_EQUAL_UINT(1, claims.failed);
    claim_at_least(&claims, nextafter(1.0, 0.0), 1.0, "N", "below");
    TEST_ASSERT_EQUAL_UINT(2, claims.failed);
    TEST_ASSERT_EQUAL_UINT(4, claims.stated);
    TEST_ASSERT_FALSE(claims_hold(&claims));
}

static void test_nothing_claimed_is_not_enough(void)
{
    const claims_t claims = {"9", 0, 0};
    TEST_ASSERT_FALSE(claims_hold(&claims));
}

static void test_no_number_holds_no_claim(void)
{
    claims_t claims = {"9", 0, 0};
    claim_at_most(&claims, not_a_number, 1.0, "N", "no number");
    claim_at_least(&claims, not_a_number, 1.0, "N", "no number");
    TEST_ASSERT_EQUAL_UINT(2, claims.failed);
}

static void test_errors_have_a_largest_and_a_root_mean_square(void)
{
    errors_t errors = {0.0, 0.0, 0};
    errors_add(&errors, 1.0);
    errors_add(&errors, -7.0);
    TEST_ASSERT_DOUBLE_WITHIN(0.0, 7.0, errors.largest);
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 5.0, errors_rms(&errors)); /* sqrt((1 + 49)/2) */
}

static void test_no_errors_at_all_have_no_root_mean_square(void)
{
    const errors_t errors = {0.0, 0.0, 0};
    const double rms = errors_rms(&errors);
    TEST_ASSERT_FALSE(rms == rms);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_claim_holds_up_to_its_limit_and_not_beyond);
    RUN_TEST(test_nothing_claimed_is_not_enough);
    RUN_TEST(test_no_number_holds_no_claim);
    RUN_TEST(test_errors_have_a_largest_and_a_root_mean_square);
    RUN_TEST(test_no_errors_at_all_have_no_root_mean_square);
    return UNITY_END() != 0;
}
