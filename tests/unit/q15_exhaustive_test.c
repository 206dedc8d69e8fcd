/* SPDX-License-Identifier: MIT */
/*
 * q15 by exhaustion, where its domains are small enough: every normalised divisor, every alpha, every
 * speed, and every pair of deflection and steady state that the quotient zeta/z_ss can tell apart.
 * Compiled with optimisation and without sanitizers, for it evaluates 10^9 of them. On an emulated
 * core the speeds and pairs are taken in strides, which leave out none of the ends.
 */
#include "../../src/q15.c" /* NOLINT(bugprone-suspicious-include) */

#include "effort.h"
#include "parameter_sets.h"
#include "unity.h"

#include <math.h>

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

/* Whichever way it counts: by comparisons, or by an instruction where there is one */
static void test_normalised_moves_the_highest_bit_up_for_every_length(void)
{
    for (int bit = 0; bit < 32; bit++) {
        const uint32_t highest = (uint32_t)1 << bit;
        const uint32_t lower[] = {0, 1, highest / 2u, highest - 1u};
        for (int i = 0; i < 4; i++) {
            const uint32_t x = highest | lower[i] % highest;
            TEST_ASSERT_EQUAL_INT(31 - bit, normalised(x).zeros);
            TEST_ASSERT_EQUAL_UINT32(x << (31 - bit), normalised(x).mantissa);
        }
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

static void check_every_speed(const epf_fixed_coeffs_t *c, const char *contact)
{
    int32_t before = c->z_max;
    for (int32_t speed = 0; speed <= 32768; speed = onward(speed, EPF_TEST_ONE_IN, 32768)) {
        epf_fixed_point_t backwards, forwards;
        prepare_point(c, (int16_t)-speed, &backwards);
        TEST_ASSERT_TRUE_MESSAGE(backwards.z_ss >= c->z_c && backwards.z_ss <= before, contact);
        if (speed < 32768) {
            prepare_point(c, (int16_t)speed, &forwards);
            TEST_ASSERT_EQUAL_INT32_MESSAGE(backwards.z_ss, forwards.z_ss, contact);
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
            epf_fixed_coeffs_t c;
            TEST_ASSERT_EQUAL_INT(EPF_OK, epf_q15_coeffs_init(&c, p, &lsb));
            check_every_speed(&c, parameter_sets[set].name);
        }
    }
}

/* Every deflection beyond z_ba that differs in the 16 bits of the quotient, for one z_ss of 30 bits */
static unsigned long failures_of_share(epf_fixed_coeffs_t *c, int32_t z_ss, int32_t z_ba)
{
    unsigned long failures = 0;
    epf_fixed_point_t point;
    c->z_ba = z_ba;
    c->z_max = z_ss;
    prepare_point(c, 0, &point);
    uint32_t before = 0;
    const int32_t stride = (int32_t)EPF_TEST_ONE_IN << 14;
    for (int32_t zeta = z_ba + 1; zeta < z_ss; zeta = onward(zeta, stride, z_ss - 1)) {
        const uint32_t k = plastic_share(c, &point, zeta);
        failures += k < before; /* below 1 by its type: ONE is 1 - 2^-16 */
        before = k;
    }
    return failures;
}

static void test_share_is_below_1_and_never_falls_for_every_pair_of_zeta_and_z_ss(void)
{
    static const int32_t elastic_shares[] = {1, 300, 500, 800, 999}; /* z_ba/z_ss in 1/1000 */
    epf_fixed_coeffs_t c = {0};
    unsigned long failures = 0;
    for (int32_t mantissa = 32768; mantissa < 65536;
         mantissa = onward(mantissa, EPF_TEST_ONE_IN, 65535)) {
        const int32_t z_ss = mantissa << 14;
        const int32_t z_ba = z_ss / 1000 * elastic_shares[mantissa / EPF_TEST_ONE_IN % 5];
        failures += failures_of_share(&c, z_ss, z_ba);
    }
    TEST_ASSERT_EQUAL_UINT32(0, failures);
}

/* The same with every elastic share for some z_ss, so that none depends on the choice above */
static void test_share_is_below_1_and_never_falls_for_every_elastic_share(void)
{
    epf_fixed_coeffs_t c = {0};
    unsigned long failures = 0;
    for (int32_t z_ss = 20011; z_ss < STATE_LIMIT;
         z_ss = z_ss < STATE_LIMIT / 7 ? z_ss * 7 : STATE_LIMIT) {
        for (int32_t share = 1; share < 1000; share = onward(share, EPF_TEST_ONE_IN, 999)) {
            failures += failures_of_share(&c, z_ss, z_ss / 1000 * share);
        }
    }
    TEST_ASSERT_EQUAL_UINT32(0, failures);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_normalised_moves_the_highest_bit_up_for_every_length);
    RUN_TEST(test_reciprocal_is_from_below_and_within_4_for_every_divisor);
    RUN_TEST(test_alpha_never_falls_and_is_within_3e_4_for_every_argument);
    RUN_TEST(test_steady_state_is_bounded_and_never_rises_over_every_speed);
    RUN_TEST(test_share_is_below_1_and_never_falls_for_every_pair_of_zeta_and_z_ss);
    RUN_TEST(test_share_is_below_1_and_never_falls_for_every_elastic_share);
    return UNITY_END() != 0;
}
