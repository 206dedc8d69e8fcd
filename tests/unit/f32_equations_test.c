/* SPDX-License-Identifier: MIT */
/* Eqs. (6) to (14) in float, each against the oracle in double precision. */
#include "effort.h"
#include "epf/f32.h"
#include "f32_walk.h"
#include "oracle.h"
#include "parameter_sets.h"
#include "unity.h"

#include <math.h>
#include <stdio.h>

static epf_params_t params;
static epf_f32_coeffs_t coeffs;

void setUp(void)
{
}

void tearDown(void)
{
}

static const epf_params_t *use_by(epf_update_t rule, int set)
{
    params = parameters_by(rule, &parameter_sets[set]);
    TEST_ASSERT_EQUAL_INT(EPF_OK, epf_f32_coeffs_init(&coeffs, &params));
    return &params;
}

static const epf_params_t *use(int set)
{
    return use_by(EPF_UPDATE_SATURATED, set);
}

/* From 1e-6 v_s to 1e6 v_s in steps of 1 % */
enum { SPEEDS = 2777, MIDDLE = 1388 };

static float speed(const epf_params_t *p, int i)
{
    return p->v_s * powf(1.01f, (float)(i - MIDDLE));
}

static void test_equations_6_to_8_agree_with_the_oracle(void)
{
    double largest = 0.0;
    for (int set = 0; set < PARAMETER_SETS; set++) {
        const epf_params_t *p = use(set);
        for (int i = 0; i < SPEEDS; i++) {
            const float v = speed(p, i);
            const double error = (double)epf_f32_fss(&coeffs, v) - oracle_fss(p, (double)v);
            largest = fmax(largest, fabs(error) / (double)p->f_max);
        }
    }
    printf("largest error of f_ss: %.2g f_max\n", largest);
    TEST_ASSERT_TRUE(largest < 3e-7);
}

static void test_equations_6_to_8_fall_with_speed_between_f_max_and_f_c(void)
{
    for (int set = 0; set < PARAMETER_SETS; set++) {
        const epf_params_t *p = use(set);
        float before = p->f_max;
        for (int i = 0; i < SPEEDS; i++) {
            const float f_ss = epf_f32_fss(&coeffs, speed(p, i));
            TEST_ASSERT_TRUE(f_ss >= p->f_c && f_ss <= p->f_max);
            TEST_ASSERT_TRUE(f_ss <= before * (1.0f + 2.0f * FLT_EPSILON)); /* but for rounding */
            before = f_ss;
        }
    }
}

static void test_equations_6_to_8_limits_and_bad_velocity(void)
{
    for (int set = 0; set < PARAMETER_SETS; set++) {
        const epf_params_t *p = use(set);
        TEST_ASSERT_TRUE(epf_f32_fss(&coeffs, 0.0f) == 0.0f);
        TEST_ASSERT_TRUE(epf_f32_fss(&coeffs, NAN) == 0.0f);
        TEST_ASSERT_TRUE(epf_f32_fss(&coeffs, INFINITY) == p->f_c);
        TEST_ASSERT_TRUE(epf_f32_fss(&coeffs, -INFINITY) == -p->f_c);
        TEST_ASSERT_TRUE(epf_f32_fss(&coeffs, -FLT_MAX) == -p->f_c);
    }
}

static void test_equation_9_steady_state_at_rest_is_z_max(void)
{
    epf_f32_t ep;
    for (int set = 0; set < PARAMETER_SETS; set++) {
        use(set);
        epf_f32_init(&ep, &coeffs);
        TEST_ASSERT_TRUE(epf_f32_update(&ep, 3.0f * coeffs.z_max, 0.0f) == coeffs.z_max);
        TEST_ASSERT_TRUE(epf_f32_update(&ep, -3.0f * coeffs.z_max, -0.0f) == -coeffs.z_max);
    }
}

static void test_equation_10_agrees_with_the_oracle(void)
{
    double largest = 0.0;
    for (int set = 0; set < PARAMETER_SETS; set++) {
        const epf_params_t *p = use(set);
        for (int i = 0; i < 3 * 4001; i++) {
            const float v = (float[]){0.01f, -1.0f, 50.0f}[i / 4001] * p->v_s;
            const float z = coeffs.z_max * (float)(i % 4001 - 2000) / 1999.0f;
            const double error =
                (double)epf_f32_alpha(&coeffs, z, v) - oracle_alpha(p, (double)z, (double)v);
            /* z_ss is rounded to float: where z_ba is close to it, alpha is that much steeper */
            const double z_ss = fabs(oracle_zss(p, (double)v));
            const double steepness = 1.6 * z_ss / (z_ss - (double)p->z_ba);
            largest = fmax(largest, fabs(error) - steepness * 2.0 * (double)FLT_EPSILON);
        }
    }
    printf("largest error of alpha: %.2g\n", largest);
    TEST_ASSERT_TRUE(largest < 1e-6);
}

static void test_equation_10_rises_from_0_at_z_ba_to_1_at_z_ss(void)
{
    for (int set = 0; set < PARAMETER_SETS; set++) {
        const epf_params_t *p = use(set);
        const float v = 0.5f * p->v_s;
        const float z_ss = epf_f32_fss(&coeffs, v) / p->sigma_0;
        float before = 0.0f;
        for (int i = 0; i <= 4000; i++) {
            const float z = p->z_ba + (z_ss - p->z_ba) * (float)i / 4000.0f;
            const float alpha = epf_f32_alpha(&coeffs, z, v);
            TEST_ASSERT_TRUE(alpha >= 0.0f && alpha <= 1.0f);
            TEST_ASSERT_TRUE(alpha >= before - 2.0f * FLT_EPSILON);
            before = alpha;
        }
        TEST_ASSERT_TRUE(epf_f32_alpha(&coeffs, p->z_ba, v) == 0.0f);
        TEST_ASSERT_TRUE(epf_f32_alpha(&coeffs, z_ss * 1.000001f, v) == 1.0f);
    }
}

static void test_equation_10_is_0_against_the_motion_at_rest_and_for_nan(void)
{
    const epf_params_t *p = use(1);
    TEST_ASSERT_TRUE(epf_f32_alpha(&coeffs, 0.99f * coeffs.z_max, -p->v_s) == 0.0f);
    TEST_ASSERT_TRUE(epf_f32_alpha(&coeffs, -0.99f * coeffs.z_max, p->v_s) == 0.0f);
    TEST_ASSERT_TRUE(epf_f32_alpha(&coeffs, 0.99f * coeffs.z_max, 0.0f) == 0.0f);
    TEST_ASSERT_TRUE(epf_f32_alpha(&coeffs, NAN, p->v_s) == 0.0f);
    TEST_ASSERT_TRUE(epf_f32_alpha(&coeffs, 0.99f * coeffs.z_max, NAN) == 0.0f);
    TEST_ASSERT_TRUE(epf_f32_alpha(&coeffs, INFINITY, p->v_s) == 1.0f);
    TEST_ASSERT_TRUE(epf_f32_alpha(&coeffs, -INFINITY, -p->v_s) == 1.0f);
    TEST_ASSERT_TRUE(epf_f32_alpha(&coeffs, -INFINITY, p->v_s) == 0.0f);
}

/* dw is not 0 only in the direction of the motion: a printed error of Algorithm 1 was to jump to
   alpha = 1 for every v < 0 */
static void test_algorithm_1_is_elastic_in_both_directions(void)
{
    epf_f32_t ep;
    const epf_params_t *p = use(0);
    epf_f32_init(&ep, &coeffs);
    TEST_ASSERT_TRUE(epf_f32_update(&ep, -0.5f * p->z_ba, -p->v_s) == -0.5f * p->z_ba);
    TEST_ASSERT_TRUE(epf_f32_update(&ep, 0.5f * p->z_ba, p->v_s) == 0.0f);
    TEST_ASSERT_TRUE(epf_f32_update(&ep, 0.5f * p->z_ba, p->v_s) == 0.5f * p->z_ba);
}

static const double step_error_limits[UPDATE_RULES] = {1e-6, 2e-6};
static double largest_step_errors[UPDATE_RULES];

/* dx for the oracle: finite, and a displacement of 2 z_max where it is one for z_max rounded to float */
static double displacement(const f32_step_t *step)
{
    const double leap = 2.0 * (double)step->params->f_max / (double)step->params->sigma_0;
    const double d = (double)step->d;
    const int is_leap = step->d >= 2.0f * step->coeffs->z_max;
    return (double)step->s * (is_leap ? 1e3 * leap : fmin(d, (1.0 - 1e-9) * leap));
}

static void step_agrees_with_oracle(const f32_step_t *step)
{
    if (step->s == 0.0f) {
        return;
    }
    const double z_max = (double)step->coeffs->z_max;
    const double expected =
        oracle_by_rule(step->params, (double)step->z_before, displacement(step), (double)step->v);
    const double error = fabs((double)step->z - expected) / z_max;
    double *largest = &largest_step_errors[step->params->update];
    *largest = fmax(*largest, error);
    f32_check(step, error <= step_error_limits[step->params->update],
              "a step against double precision");
}

static void test_equations_12_and_13_agree_with_the_oracle_from_the_same_state(void)
{
    f32_walk_corners_too(20000, step_agrees_with_oracle);
    printf("largest error of a step: %.2g z_max\n", largest_step_errors[EPF_UPDATE_SATURATED]);
    printf("largest error of a step, mean-value rule: %.2g z_max\n",
           largest_step_errors[EPF_UPDATE_MEAN_VALUE]);
}

static void force_agrees_with_oracle(const f32_step_t *step)
{
    if (step->is_extreme) {
        return; /* there it saturates: see f32_contract_test */
    }
    const double expected =
        oracle_guarded_force(step->params, (double)step->z_before, (double)step->z,
                             (double)step->dx, (double)step->v, (double)step->dt);
    const double ulp = (double)(FLT_EPSILON * step->coeffs->z_max);
    const double tolerance =
        (double)(step->params->sigma_1 / step->dt) * ulp +
        8.0 * (double)FLT_EPSILON * (fabs(expected) + (double)step->params->f_max);
    f32_check(step, fabs((double)step->force - expected) <= tolerance, "force, eq. (14)");
}

static void test_equation_14_agrees_with_the_oracle(void)
{
    f32_walk(20000, force_agrees_with_oracle);
}

/* From -z_ba/2 through break-away to sliding: n steps of either rule against the continuous model,
   integrated in 4000 */
static double error_of_discretisation(epf_update_t rule, int set, int steps)
{
    const epf_params_t *p = use_by(rule, set);
    epf_f32_t ep;
    epf_f32_init(&ep, &coeffs);
    epf_f32_reset(&ep, -0.5f * p->z_ba);
    const double dx = 1.8 * (double)coeffs.z_max / steps;
    double exact = (double)epf_f32_z(&ep);
    double largest = 0.0;
    for (int i = 1; i <= steps; i++) {
        (void)epf_f32_update(&ep, (float)dx, p->v_s);
        exact = oracle_continuous(p, exact, dx, (double)p->v_s, 4000u / (unsigned)steps);
        largest = fmax(largest, fabs((double)epf_f32_z(&ep) - exact));
    }
    return largest / (double)coeffs.z_max;
}

/* First order: half the step, half the error */
static void test_algorithm_1_converges_with_order_1_and_the_mean_value_rule_is_40_times_closer(void)
{
    for (int set = 0; set < PARAMETER_SETS; set++) {
        const double coarse = error_of_discretisation(EPF_UPDATE_SATURATED, set, 100);
        const double fine = error_of_discretisation(EPF_UPDATE_SATURATED, set, 400);
        const double mean_value = error_of_discretisation(EPF_UPDATE_MEAN_VALUE, set, 100);
        TEST_ASSERT_TRUE_MESSAGE(mean_value < coarse / 40.0, parameter_sets[set].name);
        TEST_ASSERT_TRUE_MESSAGE(coarse < 0.03, parameter_sets[set].name);
        TEST_ASSERT_TRUE_MESSAGE(fine < 0.4 * coarse || fine < 1e-6, parameter_sets[set].name);
    }
}

/* One step, of so many times the span z_ss - z_ba, from everywhere between the two: rms, in spans */
static double rms_of_a_step(epf_update_t rule, int set, double d_over_span)
{
    enum { STARTS = EFFORT(320) };
    const epf_params_t *p = use_by(rule, set);
    const double v = (double)p->v_s, z_ss = oracle_zss(p, v), z_ba = (double)p->z_ba;
    epf_f32_t ep;
    epf_f32_init(&ep, &coeffs);
    epf_f32_set_velocity(&ep, p->v_s);
    double sum = 0.0;
    for (int i = 0; i < STARTS; i++) {
        const float start = (float)(z_ba + (z_ss - z_ba) * (i + 0.5) / STARTS);
        const float dx = (float)(d_over_span * (z_ss - z_ba));
        epf_f32_reset(&ep, start);
        (void)epf_f32_advance(&ep, dx);
        const double exact = oracle_continuous(p, (double)start, (double)dx, v, 32);
        const double error = (double)ep.z + (double)ep.z_low - exact;
        sum += error * error;
    }
    return sqrt(sum / STARTS) / (z_ss - z_ba);
}

static void test_mean_value_rule_is_closer_to_the_continuous_model_at_every_length(void)
{
    static const struct {
        double d_over_span, times_closer;
    } steps[] = {{0.01, 40.0}, {0.1, 35.0}, {0.3, 15.0}, {1.0, 8.0}};
    for (int i = 0; i < 4 * PARAMETER_SETS; i++) {
        const int set = i / 4;
        const double d = steps[i % 4].d_over_span;
        const double saturated = rms_of_a_step(EPF_UPDATE_SATURATED, set, d);
        const double mean_value = rms_of_a_step(EPF_UPDATE_MEAN_VALUE, set, d);
        TEST_ASSERT_TRUE_MESSAGE(mean_value * steps[i % 4].times_closer < saturated,
                                 parameter_sets[set].name);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_equations_6_to_8_agree_with_the_oracle);
    RUN_TEST(test_equations_6_to_8_fall_with_speed_between_f_max_and_f_c);
    RUN_TEST(test_equations_6_to_8_limits_and_bad_velocity);
    RUN_TEST(test_equation_9_steady_state_at_rest_is_z_max);
    RUN_TEST(test_equation_10_agrees_with_the_oracle);
    RUN_TEST(test_equation_10_rises_from_0_at_z_ba_to_1_at_z_ss);
    RUN_TEST(test_equation_10_is_0_against_the_motion_at_rest_and_for_nan);
    RUN_TEST(test_algorithm_1_is_elastic_in_both_directions);
    RUN_TEST(test_equations_12_and_13_agree_with_the_oracle_from_the_same_state);
    RUN_TEST(test_equation_14_agrees_with_the_oracle);
    RUN_TEST(test_algorithm_1_converges_with_order_1_and_the_mean_value_rule_is_40_times_closer);
    RUN_TEST(test_mean_value_rule_is_closer_to_the_continuous_model_at_every_length);
    return UNITY_END() != 0;
}
