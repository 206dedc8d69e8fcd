/* SPDX-License-Identifier: MIT */
/* The estimator is odd: negated displacements and velocities negate every state and force, exactly.
 */
#include "f32_walk.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

static epf_f32_t mirror;

static void mirror_image_follows(const f32_step_t *step)
{
    if (step->index == 0) {
        epf_f32_init(&mirror, step->coeffs);
    }
    const float force = epf_f32_step(&mirror, -step->dx, -step->v, step->dt);
    f32_check(step, force == -step->force, "force of the mirror image");
    f32_check(step, epf_f32_z(&mirror) == -step->z, "state of the mirror image");
}

static void test_oddness_negated_inputs_negate_outputs_exactly(void)
{
    f32_walk_corners_too(5000, mirror_image_follows);
}

static void test_oddness_of_steady_state_and_alpha_is_exact(void)
{
    epf_f32_coeffs_t coeffs;
    const epf_params_t params = {
        1e5f, 63.0f, 0.0f, 1.0f, 1.1f, 1e-5f, 8e-6f, EPF_STRIBECK_GAUSSIAN, EPF_UPDATE_SATURATED};
    TEST_ASSERT_EQUAL_INT(EPF_OK, epf_f32_coeffs_init(&coeffs, &params));
    for (int i = 0; i <= 1000; i++) {
        const float v = 1e-7f * (float)i;
        const float z = 1.2e-8f * (float)i;
        TEST_ASSERT_TRUE(epf_f32_fss(&coeffs, -v) == -epf_f32_fss(&coeffs, v));
        TEST_ASSERT_TRUE(epf_f32_alpha(&coeffs, -z, -v) == epf_f32_alpha(&coeffs, z, v));
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_oddness_negated_inputs_negate_outputs_exactly);
    RUN_TEST(test_oddness_of_steady_state_and_alpha_is_exact);
    return UNITY_END() != 0;
}
