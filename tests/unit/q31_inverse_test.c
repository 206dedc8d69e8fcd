/* SPDX-License-Identifier: MIT */
/* quotient() of q31 does without saturation, since the inverse that it takes is never too large. */
#include "../../src/q31.c" /* NOLINT(bugprone-suspicious-include) */

#include "effort.h"
#include "unity.h"

#define SMALLEST UINT32_C(2147483648)

void setUp(void)
{
}

void tearDown(void)
{
}

/* 2^32/m in Q30: below 2, and not more than 6.5 units of 2^-30 below what it stands for */
static int is_from_below(uint32_t m)
{
    const uint32_t found = inverse(m);
    const uint64_t one = (uint64_t)1 << 62;
    const uint64_t seen = (uint64_t)found * m;
    return found < SMALLEST && seen <= one && one - seen < (uint64_t)13 * m / 2u;
}

static void test_inverse_is_from_below_and_close_over_its_whole_range(void)
{
    for (uint32_t m = SMALLEST; m >= SMALLEST; m += UINT32_C(4099) * EPF_TEST_ONE_IN) {
        TEST_ASSERT_TRUE(is_from_below(m));
    }
}

static void test_inverse_is_from_below_and_close_at_both_ends(void)
{
    for (uint32_t i = 0; i < 65536u; i += EPF_TEST_ONE_IN) {
        TEST_ASSERT_TRUE(is_from_below(SMALLEST + i) && is_from_below(UINT32_MAX - i));
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_inverse_is_from_below_and_close_over_its_whole_range);
    RUN_TEST(test_inverse_is_from_below_and_close_at_both_ends);
    return UNITY_END() != 0;
}
