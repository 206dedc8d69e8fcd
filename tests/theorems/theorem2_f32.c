/* SPDX-License-Identifier: MIT */
/* Theorem 2: in steady motion the state converges to z_ss(v), from wherever it is, by either rule. */
#include "effort.h"
#include "f32_properties.h"
#include "f32_walk.h"
#include "parameter_sets.h"
#include "unity.h"

#include <math.h>

void setUp(void)
{
}

void tearDown(void)
{
}

/*
 * Steps that are enough. Up to z_ba: (1 + z_ba/Z)/(d/Z). Beyond, the distance e = 1 - zeta/Z
 * shrinks by at least a factor 1 - d/Z per step, since alpha <= 1; to 1e-8 that takes 18.5/(d/Z)
 * steps. By the mean-value rule d = Z counts as 0.62 of that, a shorter step as more; a longer one soon
 * arrives.
 */
static unsigned enough_steps(double d_over_z)
{
    return (unsigned)(30.0 / d_over_z) + 2;
}

static void converges(const parameter_set_t *set, epf_update_t rule, double start, double d_over_z,
                      double v)
{
    const epf_params_t params = parameters_by(rule, set);
    epf_f32_coeffs_t coeffs;
    epf_f32_t ep;
    (void)epf_f32_coeffs_init(&coeffs, &params);
    epf_f32_init(&ep, &coeffs);
    epf_f32_reset(&ep, (float)(start * (double)coeffs.z_max));
    epf_f32_set_velocity(&ep, (float)v);

    const float z_ss = epf_f32_fss(&coeffs, (float)v) / coeffs.sigma_0;
    const float dx = (float)(d_over_z * (double)z_ss);
    const float s = z_ss < 0.0f ? -1.0f : 1.0f;
    float before = s * epf_f32_z(&ep);
    const int from_above = before > s * z_ss;
    for (unsigned i = enough_steps(d_over_z); i > 0; i--) {
        const float zeta = s * epf_f32_advance(&ep, dx);
        TEST_ASSERT_TRUE_MESSAGE(from_above ? zeta <= before : zeta >= before, set->name);
        before = zeta;
    }
    TEST_ASSERT_TRUE_MESSAGE(before == ep.points[ep.published].z_ss, set->name);
    /* z_ss itself was computed twice: as a force, and by the estimator as a deflection */
    TEST_ASSERT_TRUE_MESSAGE(fabsf(epf_f32_z(&ep) - z_ss) <= 4.0f * FLT_EPSILON * fabsf(z_ss),
                             set->name);
}

static void test_theorem2_steady_motion_converges_to_steady_state(void)
{
    static const double starts[] = {-1.0, -0.3, 0.0, 0.9, 1.0};
    static const double steps[] = {3.0, 1.0, 0.1, 1e-3 * EPF_TEST_ONE_IN};
    static const double speeds[] = {0.01, 1.0, 30.0, -0.2};
    for (int set = 0; set < PARAMETER_SETS; set++) {
        for (int i = 0; i < 5 * 4 * 4 * UPDATE_RULES; i++) {
            converges(&parameter_sets[set], (epf_update_t)(i / 80), starts[i % 5], steps[i / 5 % 4],
                      speeds[i / 20 % 4] * (double)parameter_sets[set].params.v_s);
        }
    }
}

/* A fine encoder on a soft contact: a sum in float alone would stall 0.5 % below z_ss; with the coarser
   steps of a core still many roundings below it */
static void test_theorem2_steps_near_the_resolution_of_float_converge_too(void)
{
    const double step = 6e-6 * EPF_TEST_ONE_IN * EPF_TEST_ONE_IN;
    for (int set = 0; set < PARAMETER_SETS; set++) {
        for (int rule = 0; rule < UPDATE_RULES; rule++) {
            converges(&parameter_sets[set], (epf_update_t)rule, 0.5, step,
                      0.1 * (double)parameter_sets[set].params.v_s);
        }
    }
}

static void test_theorem2_displacement_of_2_z_max_arrives_at_once(void)
{
    f32_walk_corners_too(5000, f32_leap_arrives);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_theorem2_steady_motion_converges_to_steady_state);
    RUN_TEST(test_theorem2_steps_near_the_resolution_of_float_converge_too);
    RUN_TEST(test_theorem2_displacement_of_2_z_max_arrives_at_once);
    return UNITY_END() != 0;
}
