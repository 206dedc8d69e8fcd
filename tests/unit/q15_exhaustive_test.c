/* SPDX-License-Identifier: MIT */
/*
 * q15 by exhaustion, where its domains are small enough: every normalised divisor, every alpha, every
 * speed, and every pair of span and z_ss that an operating point can tell apart. Compiled with
 * optimisation and without sanitizers, for it evaluates 10^9 of them. On an emulated core the speeds and
 * pairs are taken in strides, which leave out none of the ends.
 */
#include "../../src/q15.c" /* NOLINT(bugprone-suspicious-include) */

#include "effort.h"
#include "mean_value_in_double.h"
#include "parameter_sets.h"
#include "unity.h"

#include <math.h>
#include <stdbool.h>

void setUp(void)
{
}

void tearDown(void)
{
}

/* What comes after x in a range that ends with `last`, whatever the stride */
static int32_t onward(int32_t x, int32_t stride, int32_t last)
{
    return x < last && x > last - stride ? last : x + stride;
}

static void test_inverse_is_from_below_and_within_4_for_every_divisor(void)
{
    for (uint32_t m = 32768; m < 65536; m++) {
        const uint32_t exact = 2147483647u / m;
        const uint32_t found = inverse((uint16_t)m);
        TEST_ASSERT_TRUE(found <= exact && exact - found <= 4);
    }
}

static void test_alpha_never_falls_and_is_within_3e_4_for_every_argument(void)
{
    uint32_t before = 0;
    for (uint32_t u = 0; u <= ONE; u++) {
        const uint32_t alpha = half_sine((uint16_t)u);
        const double exact = 0.5 - 0.5 * cos(3.14159265358979323846 * u / 65536.0);
        TEST_ASSERT_TRUE(alpha >= before);
        TEST_ASSERT_TRUE(fabs(alpha / 65536.0 - exact) < 3e-4);
        before = alpha;
    }
    TEST_ASSERT_EQUAL_UINT32(0, half_sine(0));
    TEST_ASSERT_EQUAL_UINT32(ONE, half_sine(ONE));
}

static void check_every_speed(const coeffs_t *c, const char *contact)
{
    int32_t before = c->z_max;
    for (uint32_t speed = 1; speed <= 32768;
         speed = (uint32_t)onward((int32_t)speed, EPF_TEST_ONE_IN, 32768)) {
        const int32_t z_ss = steady_state(c, speed);
        TEST_ASSERT_TRUE_MESSAGE(z_ss >= c->z_c && z_ss <= before, contact);
        before = z_ss;
    }
}

static void test_steady_state_is_bounded_and_never_rises_over_every_speed(void)
{
    static const float speeds_in_v_s[] = {0.3f, 3.0f, 150.0f, 20000.0f};
    for (int set = 0; set < PARAMETER_SETS; set++) {
        for (int i = 0; i < 4; i++) {
            const epf_params_t *p = &parameter_sets[set].params;
            const epf_lsb_t lsb = {p->z_ba / 2.0f, p->v_s / speeds_in_v_s[i], p->f_max / 1e4f,
                                   1e-5f};
            coeffs_t c;
            TEST_ASSERT_EQUAL_INT(EPF_OK, epf_q15_coeffs_init(&c, p, &lsb));
            check_every_speed(&c, parameter_sets[set].name);
        }
    }
}

/* ---- the operating point --------------------------------------------------------------------- */

/* 5/8 of a span, and what few bits make of it: 0.69. A span below 10^-5 z_max has no bits to tell, and
   what comes of it is within the span. */
#define MOST     INT32_C(45220)
#define SHORTEST INT32_C(5120)

/* The share of a gap, before it is cut to 16 bits, and from there without a wrap */
static uint32_t share_of_gap(const point_t *point, int32_t gap)
{
    return part(point->span_inverse, (uint16_t)((uint32_t)gap >> point->span_shift));
}

/* A gap, which is less than the span, has a share below 1, and 5/8 of a span one below 0.69; and where the span is above z_max/64, the
   shares are what they stand for within 1e-3 and what the bits of so short a z_ss are worth */
static bool shares_are_below_1_and_close(int32_t z_ss, int32_t span)
{
    const coeffs_t c = {.z_max = z_ss, .z_ba = z_ss - span};
    point_t point;
    prepare(&c, z_ss, 0, &point);
    const uint32_t last = share_of_gap(&point, span - 1);
    const double share = span * 65536.0 / z_ss;
    const double tolerance = 66.0 + 65536.0 * 16384.0 / z_ss;
    const bool is_short = span < 8388608; /* z_max/64 at the least */
    return last < 65536u &&
           (span < SHORTEST || share_of_gap(&point, span / 8 * 5) < (uint32_t)MOST) &&
           (is_short || last > 65300u) &&
           (is_short ||
            (point.span_share < share + tolerance && point.span_share > share - tolerance));
}

/* z_ss and the span enter by 16 bits, those of the span at one of two places: all spans of each, in a
   stride over z_ss that has no factor in common with them */
static void test_shares_of_a_gap_and_of_the_span_are_below_1_for_every_span(void)
{
    const int32_t stride = INT32_C(641) * EPF_TEST_ONE_IN;
    unsigned long failures = 0;
    for (int32_t i = 1; i < 65536; i = onward(i, EPF_TEST_ONE_IN, 65535)) {
        for (int32_t shift = 10; shift <= 14; shift += 4) {
            const int32_t span = i * ((int32_t)1 << shift) + ((int32_t)1 << shift) - 1;
            for (int32_t whole = span / 16384 + 1 + i % 641; whole < 65536; whole += stride) {
                failures += !shares_are_below_1_and_close(whole * 16384 + 16383, span);
                failures += !shares_are_below_1_and_close(whole * 16384, span - 1);
            }
            failures += span < STATE_LIMIT - 1 && !shares_are_below_1_and_close(span + 1, span);
        }
    }
    TEST_ASSERT_EQUAL_UINT32(0, failures);
}

/* ---- alpha zeta/z_ss ------------------------------------------------------------------------- */

/* Every gap that differs in 16 bits, for one z_ss: what deflects of a displacement never falls with it */
static unsigned long failures_of_deflecting_part(int32_t z_ss, int32_t z_ba)
{
    const coeffs_t c = {.z_max = z_ss, .z_ba = z_ba};
    const int32_t stride = (int32_t)EPF_TEST_ONE_IN << 14;
    point_t point;
    prepare(&c, z_ss, 0, &point);
    unsigned long failures = 0;
    int32_t before = 0;
    for (int32_t gap = 1; gap < z_ss - z_ba; gap = onward(gap, stride, z_ss - z_ba - 1)) {
        const int32_t y = deflecting_part(&point, share_of_span(&point, (uint32_t)gap), 65536);
        failures += y < before || y < 1 || y > 65536;
        before = y;
    }
    return failures;
}

static void test_plastic_share_never_rises_with_the_gap_for_every_z_ss(void)
{
    static const int32_t elastic_shares[] = {1, 300, 500, 800, 999}; /* z_ba/z_ss in 1/1000 */
    unsigned long failures = 0;
    for (int32_t mantissa = 32768; mantissa < 65536;
         mantissa = onward(mantissa, EPF_TEST_ONE_IN, 65535)) {
        const int32_t z_ss = mantissa * 16384;
        failures += failures_of_deflecting_part(
            z_ss, z_ss / 1000 * elastic_shares[mantissa / EPF_TEST_ONE_IN % 5]);
    }
    TEST_ASSERT_EQUAL_UINT32(0, failures);
}

/* The same with every elastic share for some z_ss, so that none depends on the choice above */
static void test_plastic_share_never_rises_with_the_gap_for_every_elastic_share(void)
{
    unsigned long failures = 0;
    for (int32_t z_ss = 20011; z_ss < STATE_LIMIT;
         z_ss = z_ss < STATE_LIMIT / 7 ? z_ss * 7 : STATE_LIMIT) {
        for (int32_t share = 1; share < 1000; share = onward(share, EPF_TEST_ONE_IN, 999)) {
            failures += failures_of_deflecting_part(z_ss, z_ss / 1000 * share);
        }
    }
    TEST_ASSERT_EQUAL_UINT32(0, failures);
}

/* ---- the mean-value rule --------------------------------------------------------------------- */

static void test_mean_root_is_within_6_of_its_parabola_for_every_argument(void)
{
    for (uint32_t v = 0; v <= ONE; v++) {
        const double exact = 65536.0 * root_in_double(v / 65536.0);
        TEST_ASSERT_TRUE(fabs(mean_root((fraction_t)v) - exact) <= 6.0);
    }
}

static double share_error(uint32_t u, uint32_t p, uint32_t r)
{
    const fraction_t w = mean_share((fraction_t)u, (fraction_t)p, (fraction_t)r);
    return w > u ? 1.0 : fabs(w / 65536.0 - share_in_double(u / 65536.0, p / 65536.0, r / 65536.0));
}

/* On a grid over all that comes in, the ends included: no intermediate value reaches 1, for its wrap would
   be seen */
static void test_mean_share_is_close_and_does_not_wrap_over_all_fractions(void)
{
    const int32_t strides[] = {251 + 20 * (EPF_TEST_ONE_IN - 1), 499 + 10 * (EPF_TEST_ONE_IN - 1)};
    double worst = 0.0;
    for (int32_t r = 0; r < 65536; r = onward(r, INT32_C(509) * EPF_TEST_ONE_IN, 65535)) {
        for (int32_t u = 0; u < 65536; u = onward(u, strides[0], 65535)) {
            for (int32_t p = 0; p <= MOST; p = onward(p, strides[1], MOST)) {
                worst = fmax(worst, share_error((uint32_t)u, (uint32_t)p, (uint32_t)r));
            }
        }
    }
    TEST_ASSERT_TRUE(worst < 4e-4);
}

/* A displacement has 16 bits, but for the shift by which it enters the state */
static int32_t of_16_bits(int64_t d)
{
    int shift = 0;
    while (d >> shift > 65535) {
        shift++;
    }
    return (int32_t)(d >> shift << shift);
}

/* For every z_ss of 16 bits, those beyond them all 0 or all 1: over displacements up to 4 z_ss, where the
   ratio is next to 1 */
static unsigned long failures_of_let_go(int32_t z_ss)
{
    static const int32_t excess = 536870911;
    unsigned long failures = 0;
    for (int64_t k = 1; k < 300; k += 1 + k / 4) {
        const int64_t ends[] = {z_ss * k / 64, 4 * (int64_t)z_ss - k, 4 * (int64_t)z_ss - k * 256};
        for (int i = 0; i < 3; i++) {
            const bool fits = ends[i] > 0 && ends[i] < 2 * (int64_t)STATE_LIMIT;
            failures += fits && !let_go_is_close(z_ss, excess, of_16_bits(ends[i]), 4e-4);
        }
    }
    return failures;
}

static void test_excess_let_go_is_close_for_every_z_ss_and_up_to_4_of_them(void)
{
    unsigned long failures = 0;
    for (int32_t whole = 32768; whole < 65536; whole = onward(whole, EPF_TEST_ONE_IN, 65535)) {
        for (int shift = 2; shift <= 14; shift += 4) {
            failures += failures_of_let_go(whole * ((int32_t)1 << shift));
            failures += failures_of_let_go((whole + 1) * ((int32_t)1 << shift) - 1);
        }
    }
    TEST_ASSERT_EQUAL_UINT32(0, failures);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_inverse_is_from_below_and_within_4_for_every_divisor);
    RUN_TEST(test_alpha_never_falls_and_is_within_3e_4_for_every_argument);
    RUN_TEST(test_steady_state_is_bounded_and_never_rises_over_every_speed);
    RUN_TEST(test_shares_of_a_gap_and_of_the_span_are_below_1_for_every_span);
    RUN_TEST(test_plastic_share_never_rises_with_the_gap_for_every_z_ss);
    RUN_TEST(test_plastic_share_never_rises_with_the_gap_for_every_elastic_share);
    RUN_TEST(test_mean_root_is_within_6_of_its_parabola_for_every_argument);
    RUN_TEST(test_mean_share_is_close_and_does_not_wrap_over_all_fractions);
    RUN_TEST(test_excess_let_go_is_close_for_every_z_ss_and_up_to_4_of_them);
    return UNITY_END() != 0;
}
