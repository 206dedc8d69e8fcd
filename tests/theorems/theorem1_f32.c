/* SPDX-License-Identifier: MIT */
/* Theorem 1: the state is bounded by z_max, whatever the inputs are. */
#include "f32_walk.h"
#include "unity.h"

#include <math.h>

void setUp(void)
{
}

void tearDown(void)
{
}

static void state_is_bounded(const f32_step_t *step)
{
    f32_check(step, fabsf(step->z) <= step->coeffs->z_max, "|z| <= z_max");
}

static void test_theorem1_state_is_bounded_for_any_sequence(void)
{
    f32_walk_corners_too(5000, state_is_bounded);
}

/* The bound is that of the moment: after a motion the state is within z_ss(v), or, by the mean-value rule,
   not further beyond it than it was */
static void state_is_bounded_by_z_ss(const f32_step_t *step)
{
    if (step->s != 0.0f) {
        const float bound = step->params->update == EPF_UPDATE_SATURATED
                                ? step->z_ss
                                : fmaxf(step->zeta_before, step->z_ss);
        f32_check(step, step->zeta <= bound, "zeta' <= z_ss(v), or zeta");
        f32_check(step, step->zeta >= fminf(step->zeta_before, step->z_ss), "zeta' >= zeta or Z");
    } else {
        f32_check(step, step->z == step->z_before, "dx = 0 changes nothing");
    }
}

static void test_theorem1_state_after_motion_is_bounded_by_steady_state(void)
{
    f32_walk_corners_too(5000, state_is_bounded_by_z_ss);
}

static void force_is_finite(const f32_step_t *step)
{
    f32_check(step, isfinite(step->force), "force is finite");
}

static void test_theorem1_force_is_finite_for_any_sequence(void)
{
    f32_walk_corners_too(5000, force_is_finite);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_theorem1_state_is_bounded_for_any_sequence);
    RUN_TEST(test_theorem1_state_after_motion_is_bounded_by_steady_state);
    RUN_TEST(test_theorem1_force_is_finite_for_any_sequence);
    return UNITY_END() != 0;
}
