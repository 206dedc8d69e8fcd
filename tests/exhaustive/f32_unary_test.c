/* SPDX-License-Identifier: MIT */
/*
 * The functions of one float in src/f32.c for every float that can reach them, against libm in double
 * precision: the exponential of eq. (7), the half period of a sine of eq. (10), and the mean-value rule's
 * root; and one displacement of a contact for every float, from chosen states.
 */
#include "../../src/f32.c" /* NOLINT(bugprone-suspicious-include) */

#include "unity.h"

#include <math.h>

void setUp(void)
{
}

void tearDown(void)
{
}

static const double pi = 3.14159265358979323846;

/* Below 2^-26 it is 1, and above 127 log 2 it is 0; between them against libm */
static void test_exponential_is_within_3e_7_and_in_0_to_1_for_every_float(void)
{
    double largest = 0.0;
    for (uint32_t bits = 0; bits <= bits_of(INFINITY); bits++) {
        const float q = from_bits(bits);
        const float found = exp_minus(q);
        if (!(found >= 0.0f && found <= 1.0f) || (q < 0x1p-26f && found != 1.0f) ||
            (q > 88.1f && found != 0.0f)) {
            TEST_FAIL_MESSAGE("exp(-q)");
        }
        if (q >= 0x1p-26f && q <= 88.1f) {
            largest = fmax(largest, fabs((double)found - exp(-(double)q)));
        }
    }
    TEST_ASSERT_TRUE(largest < 3e-7);
    TEST_ASSERT_FLOAT_IS_NAN(exp_minus(NAN));
}

/* u is at most 1 but for rounding, and even that only reaches 1 + 2^-21 */
static void test_elastic_share_is_in_0_to_1_for_every_float(void)
{
    for (uint32_t bits = 0; bits <= bits_of(1.0f + 0x1p-20f); bits++) {
        const float share = elastic_share(from_bits(bits));
        if (!(share >= 0.0f && share <= 1.0f)) {
            TEST_FAIL_MESSAGE("share outside of [0, 1]");
        }
    }
}

static void test_elastic_share_is_within_8e_7_of_the_sine_for_every_float(void)
{
    double largest = 0.0;
    /* below 2^-40 both are below the tolerance */
    for (uint32_t bits = bits_of(0x1p-40f); bits <= bits_of(1.0f); bits++) {
        const float u = from_bits(bits);
        const double sine = sin(pi / 2.0 * (double)u);
        largest = fmax(largest, fabs((double)elastic_share(u) - sine * sine));
    }
    TEST_ASSERT_TRUE(largest < 8e-7);
    TEST_ASSERT_TRUE(elastic_share(0.0f) == 0.0f);
    TEST_ASSERT_TRUE(elastic_share(1.0f) == 1.0f);
}

/* (1 - exp(-4 v))/(4 v), the mean of an exponential over a step, has a square root not far from it; below
   2^-4 the two are as close as the terms of v^2 that differ */
static void test_mean_root_is_in_0_6_to_1_and_near_the_root_for_every_float(void)
{
    double largest = 0.0;
    for (uint32_t bits = bits_of(0x1p-26f); bits <= bits_of(1.0f); bits++) {
        const float v = from_bits(bits);
        const float h = mean_root(v);
        if (!(h >= 0.5999999f && h <= 1.0f)) {
            TEST_FAIL_MESSAGE("root outside of [0.6, 1]");
        }
        if (v >= 0x1p-4f) {
            const double mean = (1.0 - exp(-4.0 * (double)v)) / (4.0 * (double)v);
            largest = fmax(largest, fabs((double)h - sqrt(mean)));
        }
    }
    TEST_ASSERT_TRUE(largest < 0.13);
    TEST_ASSERT_TRUE(mean_root(0.0f) == 1.0f);
}

/* ---- one displacement ----------------------------------------------------------------------- */

/* Table II, v_s, where z_ss is 1.25e-5 m */
static const epf_f32_coeffs_t table_2 = EPF_F32_COEFFS(
    1e5f, 1e3f, 0.4f, 1.0f, 1.5f, 1e-3f, 8e-6f, EPF_STRIBECK_LORENTZIAN, EPF_UPDATE_MEAN_VALUE);

/* How far from z_ss a displacement from a start ends; in z_ss exactly, from 2 z_max on */
static double gap_after(epf_f32_t ep, float dx)
{
    (void)epf_f32_advance(&ep, dx);
    return (double)ep.points[ep.published].z_ss - (double)ep.z - (double)ep.z_low;
}

/* For every float from 2^-6 z_max to twice z_max: it ends between where it was and z_ss, and the nearer to
   z_ss the longer it is, but for so much rounding */
static double ends_nearer_the_longer_it_is(float start)
{
    epf_f32_t ep;
    epf_f32_init(&ep, &table_2);
    epf_f32_reset(&ep, start);
    epf_f32_set_velocity(&ep, 1e-3f);
    const double s = start > 1.25e-5f ? -1.0 : 1.0;
    const double gap = s * gap_after(ep, 0.0f);
    double least = gap, setback = 0.0;
    for (uint32_t bits = bits_of(table_2.z_max * 0x1p-6f); bits < bits_of(2.0f * table_2.z_max);
         bits++) {
        const double left = s * gap_after(ep, from_bits(bits));
        if (!(left >= 0.0 && left <= gap)) {
            TEST_FAIL_MESSAGE("beyond z_ss, or away from it");
        }
        setback = fmax(setback, left - least);
        least = fmin(least, left);
    }
    TEST_ASSERT_TRUE(gap_after(ep, 2.0f * table_2.z_max) == 0.0);
    return setback / (double)table_2.z_max;
}

static void
test_mean_value_rule_ends_nearer_to_z_ss_the_longer_the_displacement_for_every_float(void)
{
    static const float starts[] = {-1.5e-5f, 3e-6f, 8.5e-6f, 1.2e-5f, 1.26e-5f, 1.5e-5f};
    double setback = 0.0;
    for (int i = 0; i < 6; i++) {
        setback = fmax(setback, ends_nearer_the_longer_it_is(starts[i]));
    }
    TEST_ASSERT_TRUE(setback < 4e-7);
}

static int is_normal(float x)
{
    return x >= FLT_MIN && x <= FLT_MAX;
}

/* The largest has the smallest reciprocal, so that the ends say it for all between them */
static void test_what_has_a_reciprocal_has_a_normal_one(void)
{
    const float first = FLT_MIN, last = from_bits(bits_of(0x1p126f) - 1u);
    TEST_ASSERT_TRUE(has_reciprocal(first) && is_normal(1.0f / first));
    TEST_ASSERT_TRUE(has_reciprocal(last) && is_normal(1.0f / last));
    static const float others[] = {0.0f,     -0.0f,    -1.0f,     0x1p-127f,
                                   0x1p126f, INFINITY, -INFINITY, NAN};
    for (int i = 0; i < 8; i++) {
        TEST_ASSERT_FALSE(has_reciprocal(others[i]));
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_exponential_is_within_3e_7_and_in_0_to_1_for_every_float);
    RUN_TEST(test_elastic_share_is_in_0_to_1_for_every_float);
    RUN_TEST(test_elastic_share_is_within_8e_7_of_the_sine_for_every_float);
    RUN_TEST(test_mean_root_is_in_0_6_to_1_and_near_the_root_for_every_float);
    RUN_TEST(test_mean_value_rule_ends_nearer_to_z_ss_the_longer_the_displacement_for_every_float);
    RUN_TEST(test_what_has_a_reciprocal_has_a_normal_one);
    return UNITY_END() != 0;
}
