/* SPDX-License-Identifier: MIT */
/* The lemmas and theorems in integers: all of them exactly, none with a tolerance. */
#include "effort.h"
#include "fixed_walk.h"
#include "oracle.h"
#include "parameter_sets.h"
#include "unity.h"

#include <math.h>
#include <stdio.h>

enum { SAMPLES = 3000 };

void setUp(void)
{
}

void tearDown(void)
{
}

static int64_t at_most(int64_t x, int64_t bound)
{
    return x < bound ? x : bound;
}

static int64_t plastic_displacement(const fixed_step_t *step)
{
    return step->d - (step->zeta - step->zeta_before);
}

/* ---- Theorem 1 ------------------------------------------------------------------------------ */

static void state_is_bounded(const fixed_step_t *step)
{
    fixed_check(step, step->z <= step->coeffs->z_max && step->z >= -step->coeffs->z_max,
                "|z| <= z_max");
    if (step->s == 0) {
        fixed_check(step, step->z == step->z_before, "dx = 0 changes nothing");
    } else {
        fixed_check(step, step->zeta <= step->z_ss, "zeta' <= z_ss(v)");
    }
    fixed_check(step, step->z_ss >= step->coeffs->z_c && step->z_ss <= step->coeffs->z_max,
                "z_c <= z_ss <= z_max");
}

static void test_theorem1_state_is_bounded_for_any_sequence(void)
{
    fixed_walk(SAMPLES, state_is_bounded);
}

/* ---- Lemmas --------------------------------------------------------------------------------- */

static void deflects_by_part_of_the_displacement(const fixed_step_t *step)
{
    if (step->s != 0 && step->zeta_before < step->z_ss) {
        fixed_check(step, step->zeta > step->zeta_before, "strict progress below z_ss");
        fixed_check(step, step->zeta <= at_most(step->zeta_before + step->d, step->z_ss),
                    "zeta' <= min(zeta + d, z_ss)");
    }
}

static void test_lemma1_deflection_is_between_nothing_and_displacement(void)
{
    fixed_walk(SAMPLES, deflects_by_part_of_the_displacement);
}

static void plastic_displacement_follows_the_motion(const fixed_step_t *step)
{
    if (step->s != 0) {
        fixed_check(step, plastic_displacement(step) >= 0, "dw has the direction of the motion");
        fixed_check(step, plastic_displacement(step) == 0 || step->zeta > step->coeffs->z_ba,
                    "zeta' > z_ba wherever dw is not 0");
    }
}

static void test_lemma2_plastic_displacement_has_the_direction_of_motion(void)
{
    fixed_walk(SAMPLES, plastic_displacement_follows_the_motion);
}

static void elastic_displacement_is_all_deflection(const fixed_step_t *step)
{
    if (step->s != 0 && step->zeta_before + step->d <= step->coeffs->z_ba) {
        fixed_check(step, step->zeta == step->zeta_before + step->d, "z' = z + (dx << z_shift)");
    }
}

static void test_elastic_identity_holds_to_the_unit(void)
{
    fixed_walk(SAMPLES, elastic_displacement_is_all_deflection);
}

/* ---- Theorem 2 ------------------------------------------------------------------------------ */

/* Exactly z_ss, for every step of at least one count; the bound on the steps is that of theorem2_f32,
   with 2^-30 for the smallest number and 2^-15 for the resolution of k in q15 */
static void reaches_steady_state(const fixed_variant_t *variant, const parameter_set_t *set,
                                 float counts_in_z_ba, int32_t dx, int32_t v)
{
    const epf_lsb_t lsb = {set->params.z_ba / counts_in_z_ba, set->params.v_s / 150.0f,
                           set->params.f_max / 2e4f, 1e-5f};
    epf_fixed_coeffs_t c;
    epf_fixed_t ep;
    TEST_ASSERT_EQUAL_INT(EPF_OK, variant->coeffs_init(&c, &set->params, &lsb));
    variant->init(&ep, &c);
    variant->reset(&ep, dx > 0 ? -c.z_max : c.z_max);
    variant->set_velocity(&ep, v);
    const int32_t z_ss = ep.points[ep.published].z_ss;
    const double steps = 60.0 * c.z_max / (fabs((double)dx) * (double)(1L << c.z_shift)) + 2.0;
    for (long i = 0; i < (long)steps && ep.z != (dx > 0 ? z_ss : -z_ss); i++) {
        (void)variant->advance(&ep, dx);
    }
    TEST_ASSERT_EQUAL_INT32_MESSAGE(dx > 0 ? z_ss : -z_ss, ep.z, set->name);
    (void)variant->advance(&ep, dx);
    TEST_ASSERT_EQUAL_INT32_MESSAGE(dx > 0 ? z_ss : -z_ss, ep.z, set->name); /* and it stays */
}

/* Not a million counts one by one on an emulated core */
static int32_t larger(int32_t dx)
{
    const int32_t least = 10 * (EPF_TEST_ONE_IN - 1); /* on a host, none */
    return dx > 0 ? (int32_t)fmax(dx, least) : (int32_t)fmin(dx, -least);
}

static void test_theorem2_every_count_leads_exactly_to_steady_state(void)
{
    static const int32_t steps[] = {1, -1, 2, 7, -100, 30000};
    const float many_counts = fmaxf(1.0f, EFFORT(300.0f));
    for (int i = 0; i < FIXED_VARIANTS; i++) {
        for (int set = 0; set < PARAMETER_SETS; set++) {
            for (int j = 0; j < 6 * 3; j++) {
                const int32_t v = (int32_t[]){0, 150, -5000}[j / 6];
                const bool fine = set == 6; /* z_max is a million z_ba */
                reaches_steady_state(fixed_variants[i], &parameter_sets[set],
                                     fine ? 1.0f : many_counts,
                                     fine ? larger(steps[j % 6]) : steps[j % 6], v);
            }
        }
    }
}

static void leap_arrives(const fixed_step_t *step)
{
    if (step->d >= 2 * (int64_t)step->coeffs->z_max) {
        fixed_check(step, step->zeta == step->z_ss, "d >= 2 z_max ends in z_ss");
    }
}

static void test_theorem2_displacement_of_2_z_max_arrives_at_once(void)
{
    fixed_walk(SAMPLES, leap_arrives);
}

/* ---- Theorems 3 and 4 ----------------------------------------------------------------------- */

static void force_opposes_plastic_motion(const fixed_step_t *step)
{
    if (step->s != 0 && plastic_displacement(step) != 0) {
        fixed_check(step, step->s * step->internal_force > 0, "f dw > 0");
        fixed_check(step, step->s * step->force >= 0, "f dw >= 0 for the rounded force");
    }
}

static void test_theorem3_plastic_displacement_dissipates_for_every_sigma_1(void)
{
    fixed_walk(SAMPLES, force_opposes_plastic_motion);
}

/* 2 f dx - 2 (W_k - W_{k-1}) in sigma_0 u^2. A step beyond 4 z_max says no more than one of 4 z_max,
   and leaves room in 64 bits for a force of 2^28. */
static double excess_of_work(const fixed_step_t *step, double force_along)
{
    const double d = fmin((double)step->d, 4.0 * (double)step->coeffs->z_max);
    const double zeta = (double)step->zeta;
    const double before = (double)step->zeta_before;
    return 2.0 * force_along * d - (zeta - before) * (zeta + before);
}

static void no_step_yields_energy(const fixed_step_t *step)
{
    if (step->s == 0) {
        return;
    }
    /* what is beyond 2^30 only adds: the product is exact in 64 bits */
    int64_t f = step->s * step->internal_force;
    const int64_t room = (int64_t)1 << 30;
    f = f > room ? room : f;
    const int64_t d = at_most(step->d, 2 * (int64_t)step->coeffs->z_max);
    if (f < -room) {
        fixed_check(step, excess_of_work(step, (double)f) > 0.0, "2 f dx > 2 (W_k - W_{k-1})");
        return;
    }
    const int64_t stored = (step->zeta - step->zeta_before) * (step->zeta + step->zeta_before);
    fixed_check(step, 2 * f * d > stored, "2 f dx > 2 (W_k - W_{k-1})");
}

static void test_theorem4_no_step_yields_more_energy_than_was_stored(void)
{
    fixed_walk(SAMPLES, no_step_yields_energy);
}

/* ---- symmetry ------------------------------------------------------------------------------- */

static epf_fixed_t mirror;

static int32_t negated(int32_t x)
{
    return x < -INT32_MAX ? INT32_MAX : -x;
}

static bool has_mirror_image(const fixed_step_t *step)
{
    return (double)step->dx >= -step->variant->signal_max &&
           (double)step->v >= -step->variant->signal_max;
}

/* The most negative number has no mirror image: the image then starts anew from the state */
static void mirror_image_follows(const fixed_step_t *step)
{
    if (step->index == 0) {
        step->variant->init(&mirror, step->coeffs);
    }
    if (!has_mirror_image(step)) {
        step->variant->reset(&mirror, negated(step->z));
        return;
    }
    const int32_t force =
        step->variant->step(&mirror, negated(step->dx), negated(step->v), step->dt);
    fixed_check(step, mirror.z == -step->z, "state of the mirror image");
    fixed_check(step, force == -step->force, "force of the mirror image");
}

static void test_oddness_negated_inputs_negate_outputs_exactly(void)
{
    fixed_walk(SAMPLES, mirror_image_follows);
}

/* ---- drift ---------------------------------------------------------------------------------- */

static void test_drift_tremor_returns_exactly(void)
{
    static const int32_t counts[] = {3, 5, -2, 7, -1, -9, 4, -6, 1, -2};
    const long cycles = EFFORT_SQUARED(10000000L);
    for (int i = 0; i < FIXED_VARIANTS; i++) {
        const parameter_set_t *set = &parameter_sets[i];
        const epf_lsb_t lsb = {set->params.z_ba / 40.0f, set->params.v_s / 150.0f,
                               set->params.f_max / 2e4f, 1e-5f};
        epf_fixed_coeffs_t c;
        epf_fixed_t ep;
        TEST_ASSERT_EQUAL_INT(EPF_OK, fixed_variants[i]->coeffs_init(&c, &set->params, &lsb));
        fixed_variants[i]->init(&ep, &c);
        fixed_variants[i]->reset(&ep, c.z_ba / 3);
        const int32_t start = ep.z;
        for (long j = 0; j < 10 * cycles; j++) {
            (void)fixed_variants[i]->advance(&ep, counts[j % 10]);
        }
        TEST_ASSERT_EQUAL_INT32(start, ep.z);
    }
}

/* ---- accuracy ------------------------------------------------------------------------------- */

static double largest_error[FIXED_VARIANTS];

static void step_agrees_with_oracle(const fixed_step_t *step)
{
    const double z_max = (double)(step->params->f_max / step->params->sigma_0);
    const double unit = (double)step->lsb->x / (double)(1L << step->coeffs->z_shift);
    const double expected = oracle_update(step->params, (double)step->z_before * unit,
                                          (double)step->dx * (double)step->lsb->x,
                                          (double)step->v * (double)step->lsb->v);
    const double error = fabs((double)step->z * unit - expected) / z_max;
    double *largest = &largest_error[step->variant == &q15_variant];
    *largest = fmax(*largest, error);
    fixed_check(step, error <= step->variant->accuracy, "|dz| against double precision");
}

static void test_accuracy_of_a_step_from_the_same_state(void)
{
    fixed_walk(SAMPLES, step_agrees_with_oracle);
    printf("largest error of a step: q31 %.2g z_max, q15 %.2g z_max\n", largest_error[0],
           largest_error[1]);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_theorem1_state_is_bounded_for_any_sequence);
    RUN_TEST(test_lemma1_deflection_is_between_nothing_and_displacement);
    RUN_TEST(test_lemma2_plastic_displacement_has_the_direction_of_motion);
    RUN_TEST(test_elastic_identity_holds_to_the_unit);
    RUN_TEST(test_theorem2_every_count_leads_exactly_to_steady_state);
    RUN_TEST(test_theorem2_displacement_of_2_z_max_arrives_at_once);
    RUN_TEST(test_theorem3_plastic_displacement_dissipates_for_every_sigma_1);
    RUN_TEST(test_theorem4_no_step_yields_more_energy_than_was_stored);
    RUN_TEST(test_oddness_negated_inputs_negate_outputs_exactly);
    RUN_TEST(test_drift_tremor_returns_exactly);
    RUN_TEST(test_accuracy_of_a_step_from_the_same_state);
    return UNITY_END() != 0;
}
