/* SPDX-License-Identifier: MIT */
/* What decides whether a claim holds, and how far an estimate is off */
#include "claims.h"
#include "errors.h"
#include "larger.h"
#include "regimes.h"
#include "tables.h"
#include "track.h"
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
    TEST_ASSERT_DOUBLE_WITHIN(0.0, 7.0, errors_largest(&errors));
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 5.0, errors_rms(&errors)); /* sqrt((1 + 49)/2) */
}

static bool is_no_number(double x)
{
    return x != x;
}

static void test_no_errors_at_all_have_neither(void)
{
    const errors_t errors = {0.0, 0.0, 0};
    TEST_ASSERT_TRUE(is_no_number(errors_rms(&errors)));
    TEST_ASSERT_TRUE(is_no_number(errors_largest(&errors)));
}

static void test_errors_keep_one_that_is_no_number(void)
{
    for (int i = 0; i < 3; i++) { /* first, between, last */
        errors_t errors = {0.0, 0.0, 0};
        for (int j = 0; j < 3; j++) {
            errors_add(&errors, i == j ? not_a_number : 1.0);
        }
        TEST_ASSERT_TRUE(is_no_number(errors_rms(&errors)));
        TEST_ASSERT_TRUE(is_no_number(errors_largest(&errors)));
    }
}

static void test_larger_and_smaller_keep_what_is_no_number(void)
{
    TEST_ASSERT_DOUBLE_WITHIN(0.0, 2.0, larger(-1.0, 2.0));
    TEST_ASSERT_DOUBLE_WITHIN(0.0, 2.0, larger(2.0, -1.0));
    TEST_ASSERT_DOUBLE_WITHIN(0.0, -1.0, smaller(-1.0, 2.0));
    TEST_ASSERT_DOUBLE_WITHIN(0.0, -1.0, smaller(2.0, -1.0));
    TEST_ASSERT_TRUE(is_no_number(larger(not_a_number, 1.0)));
    TEST_ASSERT_TRUE(is_no_number(larger(1.0, not_a_number)));
    TEST_ASSERT_TRUE(is_no_number(smaller(not_a_number, 1.0)));
    TEST_ASSERT_TRUE(is_no_number(smaller(1.0, not_a_number)));
}

/* z_ba is 8 um, z_max 15 um; at v_s z_ss is 12.5 um, and 95 % of it 11.875 um */
static void test_a_contact_is_found_in_its_regime_whichever_way_it_moves(void)
{
    static const double at[] = {-14e-6, 8e-6, 9e-6, 11.8e-6, 11.9e-6, 12.4e-6, 12.6e-6, 15e-6};
    for (int sign = -1; sign <= 1; sign += 2) {
        regimes_t regimes = {{0}};
        for (unsigned i = 0; i < sizeof at / sizeof at[0]; i++) {
            regimes_add(&regimes, &friction_table_2, sign * at[i], sign * 1e-3);
        }
        for (int i = 0; i < REGIMES; i++) {
            TEST_ASSERT_DOUBLE_WITHIN(0.0, 25.0, regimes_percent(&regimes, (regime_t)i));
        }
    }
}

static void test_a_regime_of_no_contact_at_all_is_no_number(void)
{
    const regimes_t regimes = {{0}};
    TEST_ASSERT_TRUE(is_no_number(regimes_percent(&regimes, REGIME_ELASTIC)));
}

static void test_a_regime_that_is_a_rarity_fails(void)
{
    claims_t claims = {"9", 0, 0};
    const regimes_t regimes = {{50, 50, 96, 4}}; /* 25, 25, 48 and 2 % */
    regimes_claim(&regimes, REGIME_CASE_1, &claims, "looks");
    TEST_ASSERT_EQUAL_UINT(0, claims.failed);
    regimes_claim(&regimes, REGIMES, &claims, "looks");
    TEST_ASSERT_EQUAL_UINT(1, claims.failed);
    TEST_ASSERT_EQUAL_UINT(7, claims.stated);
}

/* ---- an estimator that follows ------------------------------------------------------------------- */

static void test_a_track_follows_an_elastic_contact_by_its_trigger(void)
{
    track_t track;
    const epf_params_t params = params_of(&friction_table_2, EPF_UPDATE_MEAN_VALUE);
    track_start(&track, &variant_f32, &params, 1e-6, 3.0);
    TEST_ASSERT_FALSE(track_look(&track, 3.0 + 0.9e-6, 0.1, 0.9e-6));
    TEST_ASSERT_TRUE(track_look(&track, 3.0 + 2e-6, 0.2, 1.5e-6));
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 2e-6, track_z(&track));
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 0.5e-6, errors_largest(&track.errors));
    /* 1e5 N/m, and the damping of 10 um/s: 1e3 N s/m, and 0.4 N s/m */
    TEST_ASSERT_DOUBLE_WITHIN(1e-6, 0.2 + 0.01 + 4e-6, track_force(&track));
}

static void test_a_track_that_the_library_refuses_holds_no_claim(void)
{
    static const variant_t *const variants[] = {&variant_f32, &variant_q31, &variant_q15};
    for (unsigned i = 0; i < sizeof variants / sizeof variants[0]; i++) {
        track_t track;
        epf_params_t params = params_of(&friction_table_2, EPF_UPDATE_MEAN_VALUE);
        params.z_ba = -1.0f;
        track_start(&track, variants[i], &params, 0.0, 0.0);
        track_set_z(&track, 0.0);
        TEST_ASSERT_TRUE(track_look(&track, 1e-6, 0.1, 1e-6));
        TEST_ASSERT_TRUE(is_no_number(track_z(&track)));
        TEST_ASSERT_TRUE(is_no_number(track_force(&track)));
        TEST_ASSERT_TRUE(is_no_number(errors_largest(&track.errors)));
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_claim_holds_up_to_its_limit_and_not_beyond);
    RUN_TEST(test_nothing_claimed_is_not_enough);
    RUN_TEST(test_no_number_holds_no_claim);
    RUN_TEST(test_errors_have_a_largest_and_a_root_mean_square);
    RUN_TEST(test_no_errors_at_all_have_neither);
    RUN_TEST(test_errors_keep_one_that_is_no_number);
    RUN_TEST(test_larger_and_smaller_keep_what_is_no_number);
    RUN_TEST(test_a_contact_is_found_in_its_regime_whichever_way_it_moves);
    RUN_TEST(test_a_regime_of_no_contact_at_all_is_no_number);
    RUN_TEST(test_a_regime_that_is_a_rarity_fails);
    RUN_TEST(test_a_track_follows_an_elastic_contact_by_its_trigger);
    RUN_TEST(test_a_track_that_the_library_refuses_holds_no_claim);
    return UNITY_END() != 0;
}
