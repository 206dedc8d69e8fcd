/* SPDX-License-Identifier: MIT */
/* The reciprocals of q31 are never so large that what they divide reaches 1, which would wrap to 0; nor
   does anything in the mean-value rule. */
#include "../../src/q31.c" /* NOLINT(bugprone-suspicious-include) */

#include "effort.h"
#include "integers.h"
#include "mean_value_in_double.h"
#include "unity.h"

#include <float.h>

#define SMALLEST UINT32_C(2147483648)
#define ONE_Q62  ((uint64_t)1 << 62)

#define FIVE_EIGHTHS UINT32_C(2684354560)

void setUp(void)
{
}

void tearDown(void)
{
}

/* 2^32/m in Q29: below 2, and within 2^-22 of what it stands for */
static bool is_from_below(uint32_t m)
{
    const uint32_t found = inverse(m);
    const uint64_t seen = (uint64_t)found * m * 2u;
    return found < SMALLEST / 2u && seen <= ONE_Q62 && ONE_Q62 - seen < ONE_Q62 >> 22;
}

static void test_inverse_is_from_below_and_close_over_its_whole_range(void)
{
    for (uint32_t m = SMALLEST; m >= SMALLEST; m += UINT32_C(997) * EPF_TEST_ONE_IN) {
        TEST_ASSERT_TRUE(is_from_below(m));
    }
}

static void test_inverse_is_from_below_and_close_at_both_ends(void)
{
    for (uint32_t i = 0; i < 65536u; i += EPF_TEST_ONE_IN) {
        TEST_ASSERT_TRUE(is_from_below(SMALLEST + i) && is_from_below(UINT32_MAX - i));
    }
}

/* The largest gap has a share below 1, which would wrap to 0, and 5/8 of the span one of at most that; and
   the shares are within 2^-22 */
static bool shares_are_below_1_and_close(int32_t z_ss, int32_t span)
{
    const coeffs_t c = {.z_max = z_ss, .z_ba = z_ss - span};
    point_t point;
    prepare(&c, z_ss, 0, &point);
    const uint64_t last = (uint64_t)((uint32_t)(span - 1) << point.span_zeros) * point.span_inverse;
    const uint64_t whole = (uint64_t)((uint32_t)span << point.span_zeros) * point.span_inverse;
    const uint64_t share = ((uint64_t)span << 32) / (uint32_t)z_ss;
    return last < ONE_Q62 && share_of_span(&point, (uint32_t)span / 8u * 5u) <= FIVE_EIGHTHS &&
           whole > ONE_Q62 - (ONE_Q62 >> 22) && point.span_share <= share + 8u &&
           share < point.span_share + (uint64_t)1024;
}

static void test_shares_of_an_operating_point_are_below_1_and_close(void)
{
    uint32_t random = 1;
    for (long i = 0; i < EFFORT(4000000L); i++) {
        const int32_t z_ss = (int32_t)(2u + random_below(&random, 1073741822u));
        const int32_t span = (int32_t)(1u + random_below(&random, (uint32_t)z_ss - 1u));
        TEST_ASSERT_TRUE(shares_are_below_1_and_close(z_ss, span));
        TEST_ASSERT_TRUE(shares_are_below_1_and_close(
            z_ss, 1 + (span - 1) / (int32_t)(UINT32_C(1) << random_below(&random, 30))));
    }
}

/* Where there is the least room: a span next to z_ss, and both next to 2^30 */
static void test_shares_of_an_operating_point_do_not_wrap_where_they_are_next_to_1(void)
{
    for (int32_t z_ss = 1073741823; z_ss > 1; z_ss -= 1 + z_ss / 1024 * EPF_TEST_ONE_IN) {
        for (int32_t span = z_ss - 1; span > 0 && span > z_ss - 60; span--) {
            TEST_ASSERT_TRUE(shares_are_below_1_and_close(z_ss, span));
        }
    }
}

/* ---- the mean-value rule --------------------------------------------------------------------- */

/* Of every length, from 1 to bound */
static int32_t of_every_length(uint32_t *random, int32_t bound)
{
    return (int32_t)(1u + (random_below(random, (uint32_t)bound) >> random_below(random, 31)));
}

/* 2^32 is 1. Of p, the share of a quarter of d, none is above 5/8: test_shares_of_an_operating_point */
static bool mean_share_is_close(uint32_t u, uint32_t p, uint32_t r)
{
    static const double one = 4294967296.0;
    static const double tolerance = 1e-8 + 8.0 * DBL_EPSILON; /* on AVR that of float */
    const uint32_t w = mean_share(u, p, r);
    return w <= u && fabs(w / one - share_in_double(u / one, p / one, r / one)) < tolerance;
}

static void test_mean_share_is_close_and_does_not_wrap_for_fractions_of_every_length(void)
{
    uint32_t random = 1;
    for (long i = 0; i < EFFORT(1000000L); i++) {
        const uint32_t u = random_word(&random) >> random_below(&random, 32);
        const uint32_t p = random_below(&random, FIVE_EIGHTHS) >> random_below(&random, 32);
        const uint32_t r = random_word(&random) >> random_below(&random, 32);
        TEST_ASSERT_TRUE(mean_share_is_close(u, p, r));
        TEST_ASSERT_TRUE(mean_share_is_close(ONE - u, FIVE_EIGHTHS - p, ONE - r));
        TEST_ASSERT_TRUE(mean_share_is_close(u, FIVE_EIGHTHS, ONE - r));
        TEST_ASSERT_TRUE(mean_share_is_close(ONE, p, ONE));
    }
}

static void test_excess_let_go_is_close_up_to_a_displacement_of_4_z_ss(void)
{
    uint32_t random = 1;
    for (long i = 0; i < EFFORT(1000000L); i++) {
        const int32_t z_ss = of_every_length(&random, 536870910);
        const int32_t excess = of_every_length(&random, 536870911);
        const int32_t most = 4 * z_ss - 1;
        TEST_ASSERT_TRUE(let_go_is_close(z_ss, excess, of_every_length(&random, most), 1e-6));
        TEST_ASSERT_TRUE(let_go_is_close(z_ss, excess, most, 1e-6));
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_inverse_is_from_below_and_close_over_its_whole_range);
    RUN_TEST(test_inverse_is_from_below_and_close_at_both_ends);
    RUN_TEST(test_shares_of_an_operating_point_are_below_1_and_close);
    RUN_TEST(test_shares_of_an_operating_point_do_not_wrap_where_they_are_next_to_1);
    RUN_TEST(test_mean_share_is_close_and_does_not_wrap_for_fractions_of_every_length);
    RUN_TEST(test_excess_let_go_is_close_up_to_a_displacement_of_4_z_ss);
    return UNITY_END() != 0;
}
