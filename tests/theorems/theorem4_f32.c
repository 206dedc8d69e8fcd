/* SPDX-License-Identifier: MIT */
/* Theorem 4: the estimator is passive: f dx > W_k - W_{k-1}, with W = sigma_0 z^2/2 in store. */
#include "f32_walk.h"
#include "unity.h"

#include <math.h>
#include <stdbool.h>

void setUp(void)
{
}

void tearDown(void)
{
}

/* Where double is no wider than float (AVR), the energies of the largest and of the smallest contact are
   beyond it */
static bool has_energies_in_double(const f32_step_t *step)
{
    const double energy = (double)step->params->f_max * (double)step->coeffs->z_max;
    return isfinite(4.0 * energy) && (double)FLT_EPSILON * energy >= DBL_MIN;
}

static double stored(const f32_step_t *step, float z)
{
    return (double)step->params->sigma_0 * (double)z * (double)z / 2.0;
}

/* f and z are floats: work and store are each known to an ulp or two of their largest values */
static double rounding(const f32_step_t *step)
{
    const double d = fmin((double)step->d, 2.0 * (double)step->coeffs->z_max);
    const double work = (double)step->params->f_max * (d + (double)step->coeffs->z_max);
    return 2.0 * (double)FLT_EPSILON * work;
}

static double excess_of_work(const f32_step_t *step)
{
    const double d = fmin((double)step->d, (double)FLT_MAX);
    return (double)step->force * (double)step->s * d -
           (stored(step, step->z) - stored(step, step->z_before));
}

static void no_step_yields_energy(const f32_step_t *step)
{
    if (step->s != 0.0f && has_energies_in_double(step)) {
        f32_check(step, excess_of_work(step) > -rounding(step), "f dx > W_k - W_{k-1}");
    }
}

static void test_theorem4_no_step_yields_more_energy_than_was_stored(void)
{
    f32_walk_corners_too(5000, no_step_yields_energy);
}

static double work_done, largest_rounding;

static void no_sequence_yields_energy(const f32_step_t *step)
{
    if (!has_energies_in_double(step)) {
        return;
    }
    if (step->index == 0) {
        work_done = 0.0;
        largest_rounding = 0.0;
    }
    work_done += (double)step->force * (double)step->s * fmin((double)step->d, (double)FLT_MAX);
    largest_rounding += rounding(step);
    f32_check(step, work_done >= stored(step, step->z) - largest_rounding, "sum f dx >= W_n - W_0");
}

static void test_theorem4_no_sequence_yields_energy_from_rest(void)
{
    f32_walk_corners_too(5000, no_sequence_yields_energy);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_theorem4_no_step_yields_more_energy_than_was_stored);
    RUN_TEST(test_theorem4_no_sequence_yields_energy_from_rest);
    return UNITY_END() != 0;
}
