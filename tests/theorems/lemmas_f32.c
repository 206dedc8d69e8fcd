/* SPDX-License-Identifier: MIT */
/*
 * Lemma 1: below z_ss a displacement deflects the contact by between nothing and itself.
 * Lemma 2: plastic displacement dw = dx - dz has the direction of the motion, and wherever there is
 * any, the contact is deflected that way by more than z_ba.
 */
#include "f32_walk.h"
#include "unity.h"

#include <math.h>

void setUp(void)
{
}

void tearDown(void)
{
}

/* z is shown rounded to float, so that a difference of two is off by up to one ulp of z_max */
static double rounding(const f32_step_t *step)
{
    return (double)(step->coeffs->z_max * FLT_EPSILON);
}

static void deflects_by_no_more_than_the_displacement(const f32_step_t *step)
{
    if (step->s == 0.0f || step->zeta_before >= step->z_ss) {
        return;
    }
    const double dzeta = (double)step->zeta - (double)step->zeta_before;
    f32_check(step, dzeta >= 0.0, "0 <= dzeta");
    f32_check(step, dzeta <= (double)step->d + rounding(step), "dzeta <= d");
}

static void test_lemma1_deflection_is_between_nothing_and_displacement(void)
{
    f32_walk_corners_too(5000, deflects_by_no_more_than_the_displacement);
}

static void plastic_displacement_follows_the_motion(const f32_step_t *step)
{
    if (step->s == 0.0f) {
        return;
    }
    const double dw = (double)step->d - ((double)step->zeta - (double)step->zeta_before);
    f32_check(step, dw >= -rounding(step), "dw has the direction of the motion");
    if (dw > rounding(step)) {
        f32_check(step, step->zeta >= step->coeffs->z_ba, "zeta' >= z_ba wherever dw is not 0");
    }
}

static void test_lemma2_plastic_displacement_has_the_direction_of_motion(void)
{
    f32_walk_corners_too(5000, plastic_displacement_follows_the_motion);
}

/* (b) of the proposition: what stays below z_ba is elastic */
static void elastic_displacement_is_all_deflection(const f32_step_t *step)
{
    const double end = (double)step->zeta_before + (double)step->d;
    if (step->s != 0.0f && end <= (double)step->coeffs->z_ba) {
        f32_check(step, fabs((double)step->zeta - end) <= rounding(step), "zeta' = zeta + d");
    }
}

static void test_lemma2_contact_is_elastic_below_z_ba(void)
{
    f32_walk_corners_too(5000, elastic_displacement_is_all_deflection);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_lemma1_deflection_is_between_nothing_and_displacement);
    RUN_TEST(test_lemma2_plastic_displacement_has_the_direction_of_motion);
    RUN_TEST(test_lemma2_contact_is_elastic_below_z_ba);
    return UNITY_END() != 0;
}
