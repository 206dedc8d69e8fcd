/* SPDX-License-Identifier: MIT */
/* No drift: what an encoder counts to and fro below z_ba ends in the bits where it began. */
#include "effort.h"
#include "epf/f32.h"
#include "parameter_sets.h"
#include "unity.h"

#include <math.h>

void setUp(void)
{
}

void tearDown(void)
{
}

/* A count of 16 significant bits: its multiples are exact, so that a cycle sums to exactly 0 */
static float coarse(float x)
{
    int exponent;
    const double fraction = frexp((double)x, &exponent);
    return (float)ldexp(floor(ldexp(fraction, 16)), exponent - 16);
}

static void test_drift_encoder_counts_return_to_the_same_bits(void)
{
    static const int counts[] = {3, 5, -2, 7, -1, -9, 4, -6, 1, -2};
    const long cycles = EFFORT_SQUARED(500000L);
    for (int contact = 0; contact < PARAMETER_SETS * UPDATE_RULES; contact++) {
        const parameter_set_t *set = &parameter_sets[contact / UPDATE_RULES];
        const epf_params_t params = parameters_by((epf_update_t)(contact % UPDATE_RULES), set);
        epf_f32_coeffs_t coeffs;
        epf_f32_t ep;
        (void)epf_f32_coeffs_init(&coeffs, &params);
        epf_f32_init(&ep, &coeffs);
        epf_f32_reset(&ep, 0.3f * coeffs.z_ba);
        const float start = epf_f32_z(&ep);
        const float count = coarse(coeffs.z_ba / 37.3f);
        for (long i = 0; i < 10 * cycles; i++) {
            (void)epf_f32_advance(&ep, (float)counts[i % 10] * count);
        }
        TEST_ASSERT_TRUE_MESSAGE(epf_f32_z(&ep) == start, set->name);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_drift_encoder_counts_return_to_the_same_bits);
    return UNITY_END() != 0;
}
