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
    RUN_TEST(test_what_has_a_reciprocal_has_a_normal_one);
    return UNITY_END() != 0;
}
