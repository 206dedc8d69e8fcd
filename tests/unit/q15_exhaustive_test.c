/* SPDX-License-Identifier: MIT */
/*
 * q15 by exhaustion, where its domains are small enough: every normalised divisor, every alpha, every
 * speed, and every pair of span and z_ss that an operating point can tell apart. Compiled with
 * optimisation and without sanitizers, for it evaluates 10^9 of them. On an emulated core the speeds and
 * pairs are taken in strides, which leave out none of the ends.
 */
#include "../../src/q15.c" /* NOLINT(bugprone-suspicious-include) */

#include "effort.h"
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

static void test_reciprocal_is_from_below_and_within_4_for_every_divisor(void)
{
    for (uint32_t m = 32768; m < 65536; m++) {
        const uint32_t exact = 2147483647u / m;
        const uint32_t found = reciprocal((uint16_t)m);
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
    for (int32_t speed = 0; speed <= 32768; speed = onward(speed, EPF_TEST_ONE_IN, 32768)) {
        const point_t backwards = operating_point(c, (int16_t)-speed);
        TEST_ASSERT_TRUE_MESSAGE(backwards.z_ss >= c->z_c && backwards.z_ss <= before, contact);
        if (speed < 32768) {
            const int32_t forwards = operating_point(c, (int16_t)speed).z_ss;
            TEST_ASSERT_EQUAL_INT32_MESSAGE(backwards.z_ss, forwards, contact);
        }
        before = backwards.z_ss;
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

/* From below, so that u and the share stay below 2^16, and not by more than 1e-3 */
static bool reciprocals_are_from_below(int32_t z_ss, int32_t span)
{
    const coeffs_t c = {.z_max = z_ss, .z_ba = z_ss - span};
    const point_t point = point_of(&c, z_ss, 0);
    const uint32_t leading = (uint32_t)span << point.span_zeros >> 16;
    const uint64_t unity = (uint64_t)leading * point.span_inverse;
    const uint64_t share = (uint64_t)point.span_share * (uint32_t)z_ss;
    return unity < 2147483648u && unity > 2147483648u - 2147484u &&
           share <= (uint64_t)span * 65536u &&
           share + (uint64_t)z_ss * 66u > (uint64_t)span * 65536u;
}

/* z_ss and the span enter by their 16 leading bits: a span of the same length as z_ss, and half of it */
static void test_reciprocals_are_from_below_for_every_pair_of_span_and_z_ss(void)
{
    unsigned long failures = 0;
    for (int32_t z_ss = 32768; z_ss < 65536; z_ss = onward(z_ss, EPF_TEST_ONE_IN, 65535)) {
        const int32_t stride = EPF_TEST_ONE_IN;
        for (int32_t span = 32768; span < 65536; span = onward(span, stride, 65535)) {
            const int32_t length = span < z_ss ? 14 : 13;
            failures += !reciprocals_are_from_below(z_ss * 16384, span * ((int32_t)1 << length));
        }
    }
    TEST_ASSERT_EQUAL_UINT32(0, failures);
}

/* ---- alpha zeta/z_ss ------------------------------------------------------------------------- */

/* Every deflection beyond z_ba that differs in 16 bits, for one z_ss of 30 bits */
static unsigned long failures_of_share(int32_t z_ss, int32_t z_ba)
{
    const coeffs_t c = {.z_max = z_ss, .z_ba = z_ba};
    const point_t point = point_of(&c, z_ss, 0);
    const int32_t stride = (int32_t)EPF_TEST_ONE_IN << 14;
    unsigned long failures = 0;
    uint32_t before = 0;
    for (int32_t zeta = z_ba + 1; zeta < z_ss; zeta = onward(zeta, stride, z_ss - 1)) {
        const uint32_t share = plastic_share(&point, zeta - z_ba);
        failures += share < before; /* below 1 by its type: ONE is 1 - 2^-16 */
        before = share;
    }
    return failures;
}

static void test_share_never_falls_for_every_z_ss(void)
{
    static const int32_t elastic_shares[] = {1, 300, 500, 800, 999}; /* z_ba/z_ss in 1/1000 */
    unsigned long failures = 0;
    for (int32_t mantissa = 32768; mantissa < 65536;
         mantissa = onward(mantissa, EPF_TEST_ONE_IN, 65535)) {
        const int32_t z_ss = mantissa * 16384;
        failures +=
            failures_of_share(z_ss, z_ss / 1000 * elastic_shares[mantissa / EPF_TEST_ONE_IN % 5]);
    }
    TEST_ASSERT_EQUAL_UINT32(0, failures);
}

/* The same with every elastic share for some z_ss, so that none depends on the choice above */
static void test_share_never_falls_for_every_elastic_share(void)
{
    unsigned long failures = 0;
    for (int32_t z_ss = 20011; z_ss < STATE_LIMIT;
         z_ss = z_ss < STATE_LIMIT / 7 ? z_ss * 7 : STATE_LIMIT) {
        for (int32_t share = 1; share < 1000; share = onward(share, EPF_TEST_ONE_IN, 999)) {
            failures += failures_of_share(z_ss, z_ss / 1000 * share);
        }
    }
    TEST_ASSERT_EQUAL_UINT32(0, failures);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_reciprocal_is_from_below_and_within_4_for_every_divisor);
    RUN_TEST(test_alpha_never_falls_and_is_within_3e_4_for_every_argument);
    RUN_TEST(test_steady_state_is_bounded_and_never_rises_over_every_speed);
    RUN_TEST(test_reciprocals_are_from_below_for_every_pair_of_span_and_z_ss);
    RUN_TEST(test_share_never_falls_for_every_z_ss);
    RUN_TEST(test_share_never_falls_for_every_elastic_share);
    return UNITY_END() != 0;
}
