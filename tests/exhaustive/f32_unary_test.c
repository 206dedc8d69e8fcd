/* SPDX-License-Identifier: MIT */
/*
 * The functions of one float in src/f32.c for every float that can reach them, against libm in double
 * precision: the exponential of eq. (7) and the half period of a sine of eq. (10).
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

static void test_exponential_is_within_3e_7_and_in_0_to_1_for_every_float(void)
{
    double largest = 0.0;
    for (uint32_t bits = 0; bits <= bits_of(INFINITY); bits++) {
        const float q = from_bits(bits);
        const float found = exp_minus(q);
        if (!(found >= 0.0f && found <= 1.0f)) {
            TEST_FAIL_MESSAGE("exp(-q) outside of [0, 1]");
        }
        if (q < 200.0f) {
            largest = fmax(largest, fabs((double)found - exp(-(double)q)));
        } else if (found != 0.0f) {
            TEST_FAIL_MESSAGE("exp(-q) is not 0 for a large q");
        }
    }
    TEST_ASSERT_TRUE(largest < 3e-7);
    TEST_ASSERT_TRUE(exp_minus(0.0f) == 1.0f);
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

/* Every exponent, and every mantissa of 23 bits at two of them: a float has a reciprocal that is normal */
static void test_what_has_reciprocal_accepts_has_a_normal_one_for_every_float(void)
{
    for (uint32_t bits = 0; bits < bits_of(INFINITY); bits++) {
        const float x = from_bits(bits);
        const float inverse = 1.0f / x;
        const int is_normal = inverse >= FLT_MIN && inverse <= FLT_MAX && x >= FLT_MIN;
        if (has_reciprocal(x) && !is_normal) {
            TEST_FAIL_MESSAGE("accepted, but has no normal reciprocal");
        }
    }
    TEST_ASSERT_FALSE(has_reciprocal(NAN));
    TEST_ASSERT_FALSE(has_reciprocal(INFINITY));
    TEST_ASSERT_FALSE(has_reciprocal(-1.0f));
    TEST_ASSERT_FALSE(has_reciprocal(0.0f));
    TEST_ASSERT_TRUE(has_reciprocal(FLT_MIN));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_exponential_is_within_3e_7_and_in_0_to_1_for_every_float);
    RUN_TEST(test_elastic_share_is_in_0_to_1_for_every_float);
    RUN_TEST(test_elastic_share_is_within_8e_7_of_the_sine_for_every_float);
    RUN_TEST(test_what_has_reciprocal_accepts_has_a_normal_one_for_every_float);
    return UNITY_END() != 0;
}
