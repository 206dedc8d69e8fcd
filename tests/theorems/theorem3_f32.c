/* SPDX-License-Identifier: MIT */
/* Theorem 3: plastic displacement dissipates, f dw > 0; by the guard, for every sigma_1 and dt. */
#include "effort.h"
#include "f32_walk.h"
#include "oracle.h"
#include "sequences.h"
#include "unity.h"

#include <math.h>

void setUp(void)
{
}

void tearDown(void)
{
}

static bool is_plastic(const f32_step_t *step)
{
    return step->s != 0.0f &&
           (step->zeta_before > step->coeffs->z_ba || step->zeta > step->coeffs->z_ba);
}

/* dw has the direction of the motion (Lemma 2), so f must have it too */
static void force_opposes_plastic_motion(const f32_step_t *step)
{
    if (is_plastic(step)) {
        f32_check(step, step->s * step->force > 0.0f, "f dw > 0");
    }
}

static void test_theorem3_plastic_displacement_dissipates_for_every_sigma_1(void)
{
    f32_walk_corners_too(5000, force_opposes_plastic_motion);
}

static unsigned violations, guarded, steps_within_bound;

static void count_violations_without_guard(const f32_step_t *step)
{
    if (is_plastic(step) && !step->is_extreme) {
        const double f = oracle_force(step->params, (double)step->z_before, (double)step->z,
                                      (double)step->dx, (double)step->v, (double)step->dt);
        violations += (double)step->s * f <= 0.0;
    }
}

static void test_theorem3_fails_without_the_guard_far_outside_of_equation_22(void)
{
    violations = 0;
    f32_walk(5000, count_violations_without_guard);
    TEST_ASSERT_TRUE(violations > EFFORT(100));
}

static void force_is_as_printed_within_equation_22(const f32_step_t *step)
{
    const double limit = (double)epf_sigma_1_limit(step->params, step->v, step->dt);
    if (step->is_extreme || (double)step->params->sigma_1 > 0.99 * limit) {
        return;
    }
    const double printed = oracle_force(step->params, (double)step->z_before, (double)step->z,
                                        (double)step->dx, (double)step->v, (double)step->dt);
    /* dz between two states rounded to float: the damping term magnifies an ulp by sigma_1/dt */
    const double ulp = (double)(FLT_EPSILON * step->coeffs->z_max);
    const double damping_ulp = (double)(step->params->sigma_1 / step->dt) * ulp;
    const double tolerance =
        fabs(printed) / 1024.0 + damping_ulp +
        8.0 * (double)FLT_EPSILON *
            (double)(step->params->f_max + step->params->sigma_2 * fabsf(step->v));
    f32_check(step, fabs((double)step->force - printed) <= tolerance, "the guard changes nothing");
    steps_within_bound++;
    guarded += step->zeta < step->zeta_before;
}

static void test_theorem3_guard_changes_nothing_within_equation_22(void)
{
    guarded = steps_within_bound = 0;
    f32_walk(5000, force_is_as_printed_within_equation_22);
    TEST_ASSERT_TRUE(steps_within_bound > EFFORT(100000));
    TEST_ASSERT_TRUE_MESSAGE(guarded > EFFORT(1000), "case 1 must have occurred");
}

/* A contact whose f_max is 1.001 to 11 times f_c, and a sigma_1 at 0.998 of eq. (22) */
static epf_params_t near_the_bound(sequence_t *q, epf_update_t rule, float dt)
{
    epf_params_t p = {1e5f, 0.0f, 0.0f, 1.0f, 1.0f, 1e-3f, 8e-6f, EPF_STRIBECK_LORENTZIAN, rule};
    p.sigma_0 = (float)sequence_uniform(q, 1e3, 1e6);
    p.f_c = (float)sequence_uniform(q, 0.5, 2.0);
    const double excess = sequence_uniform(q, 0.0, 1.0);
    p.f_max = p.f_c * (float)(1.001 + 10.0 * excess * excess * excess * excess);
    p.z_ba = p.f_c / p.sigma_0 * (float)sequence_uniform(q, 0.1, 0.9);
    p.sigma_1 = 0.998f * epf_sigma_1_limit(&p, 0.0f, dt);
    return p;
}

/* From the largest deflection towards the smallest z_ss, and up to there, the worst that case 1 can do; by
   eq. (14) itself */
static void test_theorem3_guard_changes_nothing_up_to_0_998_of_the_bound(void)
{
    sequence_t q;
    sequence_start(&q, SEQUENCE_RANDOM_WALK, 5);
    for (long i = 0; i < EFFORT(100000L); i++) {
        const float dt = 1e-3f;
        const epf_params_t p = near_the_bound(&q, (epf_update_t)(i % 2), dt);
        epf_f32_coeffs_t c;
        epf_f32_t ep;
        TEST_ASSERT_EQUAL_INT(EPF_OK, epf_f32_coeffs_init(&c, &p));
        epf_f32_init(&ep, &c);
        epf_f32_reset(&ep, c.z_max);
        const float dx = c.z_max * (float)sequence_uniform(&q, 1e-3, 2.5);
        const float force = epf_f32_step(&ep, dx, INFINITY, dt);
        const float z = epf_f32_z(&ep);
        TEST_ASSERT_TRUE(z == c.z_c || p.update == EPF_UPDATE_MEAN_VALUE);
        TEST_ASSERT_TRUE(force == c.sigma_0 * z + c.sigma_1 * ep.dz / dt);
        TEST_ASSERT_TRUE(fabsf(ep.dz - (z - c.z_max)) <= FLT_EPSILON * c.z_max);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_theorem3_plastic_displacement_dissipates_for_every_sigma_1);
    RUN_TEST(test_theorem3_fails_without_the_guard_far_outside_of_equation_22);
    RUN_TEST(test_theorem3_guard_changes_nothing_within_equation_22);
    RUN_TEST(test_theorem3_guard_changes_nothing_up_to_0_998_of_the_bound);
    return UNITY_END() != 0;
}
