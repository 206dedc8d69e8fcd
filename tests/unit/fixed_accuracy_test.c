/* SPDX-License-Identifier: MIT */
/*
 * What q31.h and q15.h say of accuracy, against double precision, over the corners of the parameters:
 * every z_shift, and gains from the smallest to the largest. The worst figures are printed.
 */
#include "effort.h"
#include "fixed_corners.h"
#include "fixed_walk.h"
#include "integers.h"
#include "oracle.h"
#include "parameter_sets.h"
#include "unity.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

void setUp(void)
{
}

void tearDown(void)
{
}

static void keep_larger(double *largest, double x)
{
    *largest = fmax(*largest, x);
}

/* ---- a step ----------------------------------------------------------------------------------
 * The paper's rule against eqs. (12) and (13) in SI units. The mean-value rule takes z_ss(v) not only for
 * where it ends, but for how fast: against itself in double precision for the z_ss(v) in use everywhere,
 * and in SI units in ordinary contacts, since the error of z_ss(v) is a share of f_max - f_c.
 */

/* By f_max/f_c: up to 2, and up to 10 */
enum { EXCESSES = 2 };
static const float excesses[EXCESSES] = {2.0f, 10.0f};
static const double si_accuracy[FIXED_VARIANTS][EXCESSES] = {{1e-5, 1e-5}, {1e-3, 2e-3}};

static double step_error[FIXED_WAYS], si_step_error[FIXED_VARIANTS][EXCESSES];

/* Of a step, against a contact of such parameters, z_max */
static double error_of(const fixed_step_t *step, const epf_params_t *params)
{
    const double unit = (double)step->lsb->x / (double)step->lengths.unit;
    const double z = (double)step->z_before * unit;
    const double dx = (double)step->dx * (double)step->lsb->x;
    const double v = (double)step->v * (double)step->lsb->v;
    return fabs((double)step->z * unit - oracle_by_rule(params, z, dx, v)) /
           (double)(step->params->f_max / step->params->sigma_0);
}

/* A contact whose z_ss is at every speed what the step had */
static epf_params_t at_steady_state_in_use(const fixed_step_t *step)
{
    epf_params_t params = *step->params;
    const double unit = (double)step->lsb->x / (double)step->lengths.unit;
    params.f_c = (float)((double)step->z_ss * unit * (double)params.sigma_0);
    params.stribeck = EPF_STRIBECK_COULOMB;
    return params;
}

/* A displacement of 2 z_max, but for its last bits: by the mean-value rule one that is not quite that long
   ends elsewhere */
static bool is_just_a_leap(const fixed_step_t *step)
{
    return llabs(step->d - 2 * (int64_t)step->lengths.z_max) < 1024;
}

static void mean_value_agrees_in_si(const fixed_step_t *step)
{
    const int variant = step->variant == &q15_variant;
    for (int i = 0; i < EXCESSES; i++) {
        if (step->params->f_max <= excesses[i] * step->params->f_c) {
            const double error = error_of(step, step->params);
            keep_larger(&si_step_error[variant][i], error);
            fixed_check(step, error <= si_accuracy[variant][i], "|dz| against SI units");
        }
    }
}

static void step_agrees_with_oracle(const fixed_step_t *step)
{
    const epf_update_t rule = step->params->update;
    epf_params_t params = *step->params;
    if (rule == EPF_UPDATE_MEAN_VALUE) {
        if (is_just_a_leap(step)) {
            return;
        }
        mean_value_agrees_in_si(step);
        params = at_steady_state_in_use(step);
    }
    const double error = error_of(step, &params);
    keep_larger(&step_error[(step->variant == &q15_variant) + FIXED_VARIANTS * rule], error);
    fixed_check(step, error <= step->variant->accuracy[rule], "|dz| against double precision");
}

static void test_a_step_is_as_accurate_as_promised(void)
{
    fixed_walk(3000, step_agrees_with_oracle);
    fixed_walk_corners(50, step_agrees_with_oracle);
    fixed_scatter(100, step_agrees_with_oracle);
    printf("largest error of a step: q31 %.2g z_max, q15 %.2g z_max\n", step_error[0],
           step_error[1]);
    printf("of the mean-value rule: q31 %.2g z_max, q15 %.2g z_max\n", step_error[2],
           step_error[3]);
    printf("and for the exact z_ss(v), f_max up to 2 f_c and up to 10 f_c: q31 %.2g and %.2g, q15 "
           "%.2g and %.2g\n",
           si_step_error[0][0], si_step_error[0][1], si_step_error[1][0], si_step_error[1][1]);
}

/* ---- alpha -----------------------------------------------------------------------------------
 * Against eq. (10) with z_ss(v) as the estimator has it; and, where the span z_ss - z_ba is above
 * z_max/64, against eqs. (7) to (10) in SI units: the error of z_ss(v) is one of alpha there, pi/2 times
 * as large and in spans.
 */

/* By the span: more than z_max/64, half of that, and so on */
enum { SPANS = 12 };
static double sine_error[FIXED_VARIANTS][SPANS], si_error[FIXED_VARIANTS];

static int halvings(int32_t span, int32_t z_max)
{
    int n = 0;
    while (n < SPANS - 1 && ((int64_t)span << (6 + n)) <= z_max) {
        n++;
    }
    return n;
}

static void compare_alpha(int i, const any_coeffs_t *coeffs, const epf_params_t *params,
                          const epf_lsb_t *lsb, int32_t v)
{
    const fixed_variant_t *variant = fixed_variants[i];
    const fixed_lengths_t c = variant->lengths(coeffs);
    any_contact_t ep;
    variant->init(&ep, coeffs);
    variant->set_velocity(&ep, v);
    const int32_t span = variant->z_ss(&ep) - c.z_ba;
    const int shortness = halvings(span, c.z_max);
    for (int k = 0; k <= 100; k++) {
        const int32_t beyond = (int32_t)((int64_t)span * k / 100);
        const double alpha = variant->alpha(coeffs, c.z_ba + beyond, v) / 1073741824.0;
        const double sine = 0.5 - 0.5 * cos(3.14159265358979323846 * beyond / span);
        keep_larger(&sine_error[i][shortness], fabs(alpha - sine));
        if (shortness == 0) {
            const double z = (c.z_ba + beyond) * ((double)lsb->x / (double)c.unit);
            const double exact = oracle_alpha(params, z, v * (double)lsb->v);
            keep_larger(&si_error[i], fabs(alpha - exact));
        }
    }
}

/* Up to 60 v_s, where |v|/v_s saturates in q15 */
static void compare_alpha_at_speeds(int i, const epf_params_t *params, const epf_lsb_t *lsb)
{
    any_coeffs_t coeffs;
    TEST_ASSERT_EQUAL_INT(EPF_OK, fixed_variants[i]->coeffs_init(&coeffs, params, lsb));
    for (int32_t v = 1; v * (double)lsb->v < 60.0 * (double)params->v_s; v += 1 + v / 3) {
        compare_alpha(i, &coeffs, params, lsb, v);
    }
}

/* z_ba so much below z_c that the span is just above z_max/64 at full speed, and f_max in all ranges */
static void compare_alpha_of_short_spans(int i, epf_stribeck_t form, float f_max_over_f_c)
{
    const float z_max = f_max_over_f_c * 1e-5f;
    const epf_params_t params = {1e5f,
                                 0.0f,
                                 0.0f,
                                 1.0f,
                                 f_max_over_f_c,
                                 1e-3f,
                                 fmaxf(1e-5f - z_max / 63.9f, 1e-6f),
                                 form,
                                 EPF_UPDATE_SATURATED};
    const epf_lsb_t lsb = {fmaxf(1e-8f, z_max / 1e9f), 1e-5f, f_max_over_f_c / 2e4f, 1e-4f};
    compare_alpha_at_speeds(i, &params, &lsb);
}

static void print_alpha_errors(int i)
{
    printf("largest error of alpha, %s: %.2g, in SI %.2g; spans below z_max/64, halved each time:",
           fixed_variants[i]->name, sine_error[i][0], si_error[i]);
    for (int n = 1; n < SPANS; n++) {
        printf(" %.1g", sine_error[i][n]);
    }
    printf("\n");
}

static void test_alpha_is_a_half_period_of_a_sine_from_z_ba_to_z_ss(void)
{
    static const double accuracy[] = {1e-5, 2e-3};
    for (int i = 0; i < FIXED_VARIANTS; i++) {
        for (int j = 0; j < FIXED_CORNERS; j += 4 + EPF_TEST_ONE_IN) {
            fixed_corner_t corner;
            if (fixed_corner(j, &corner)) {
                compare_alpha_at_speeds(i, &corner.params, &corner.lsb);
            }
        }
        for (int j = 0; j < 230; j += 1 + EPF_TEST_ONE_IN / 4) { /* f_max from f_c to 10^4 f_c */
            compare_alpha_of_short_spans(i, EPF_STRIBECK_LORENTZIAN, powf(1.04f, (float)j));
            compare_alpha_of_short_spans(i, EPF_STRIBECK_GAUSSIAN, powf(1.04f, (float)j));
        }
        print_alpha_errors(i);
        const int spans = i == 0 ? SPANS : 1; /* q31 promises it for every span */
        for (int n = 0; n < spans; n++) {
            TEST_ASSERT_TRUE(sine_error[i][n] <= accuracy[i]);
        }
        TEST_ASSERT_TRUE(sine_error[i][0] > 0.0 && si_error[i] <= accuracy[i]);
    }
}

/* ---- the continuous model --------------------------------------------------------------------
 * One displacement at constant velocity, from everywhere between z_ba and z_ss: how much closer to
 * dz/dx = 1 - alpha z/z_ss the mean-value rule comes, rms over the places.
 */

enum { PLACES = 20 + 180 / EPF_TEST_ONE_IN };

/* By this rule, in spans z_ss - z_ba, for displacements of so many spans; Table II at v_s */
static double rms_off_the_continuous_model(int way, double spans)
{
    const fixed_variant_t *variant = fixed_way_variant(way);
    const epf_params_t params = parameters_by(fixed_way_rule(way), &parameter_sets[1]);
    const epf_lsb_t lsb = {1e-9f, params.v_s / 100.0f, 1e-4f, 1e-5f};
    any_coeffs_t coeffs;
    any_contact_t ep;
    TEST_ASSERT_EQUAL_INT(EPF_OK, variant->coeffs_init(&coeffs, &params, &lsb));
    variant->init(&ep, &coeffs);
    variant->set_velocity(&ep, 100);
    const fixed_lengths_t c = variant->lengths(&coeffs);
    const int32_t span = variant->z_ss(&ep) - c.z_ba;
    const double unit = (double)lsb.x / (double)c.unit;
    const int32_t dx = (int32_t)(spans * span / (double)c.unit);
    double sum = 0.0;
    for (int i = 0; i < PLACES; i++) {
        const int32_t z = c.z_ba + (int32_t)((int64_t)span * i / PLACES);
        variant->reset(&ep, z);
        const double exact =
            oracle_continuous(&params, z * unit, dx * (double)lsb.x, (double)params.v_s, 40);
        const double off = (variant->advance(&ep, dx) - exact / unit) / span;
        sum += off * off;
    }
    return sqrt(sum / PLACES);
}

static void test_mean_value_rule_is_many_times_closer_to_the_continuous_model(void)
{
    static const double spans[] = {0.01, 0.1, 0.3, 1.0};
    static const double least_ratio[FIXED_VARIANTS][4] = {{40.0, 40.0, 20.0, 20.0},
                                                          {10.0, 40.0, 20.0, 20.0}};
    for (int i = 0; i < FIXED_VARIANTS; i++) {
        printf("off the continuous model, in spans, %s:", fixed_variants[i]->name);
        for (int k = 0; k < 4; k++) {
            const double saturated = rms_off_the_continuous_model(i, spans[k]);
            const double mean_value = rms_off_the_continuous_model(i + FIXED_VARIANTS, spans[k]);
            printf(" %.2g, 1/%.0f of it;", saturated, saturated / mean_value);
            TEST_ASSERT_TRUE(mean_value * least_ratio[i][k] < saturated);
        }
        printf("\n");
    }
}

/* ---- the terms of the force ------------------------------------------------------------------ */

/* A contact in powers of two, so that the gains are what is asked for: sigma_2 and sigma_1 of so many
   sigma_0 lsb.x for one lsb.v, and for one lsb.x in one lsb.t */
typedef struct {
    const fixed_variant_t *variant;
    any_coeffs_t coeffs;
    double units; /* of 2^8 sigma_0 u in sigma_0 lsb.x */
} gains_t;

static void use_gains(gains_t *gains, int i, int z_shift, float viscous, float damping)
{
    const float z_max = ldexpf(1.75f, 29 - z_shift);
    const epf_params_t params = {1.0f,
                                 damping,
                                 viscous,
                                 0.75f * z_max,
                                 z_max,
                                 1.0f,
                                 0.6f * z_max,
                                 EPF_STRIBECK_COULOMB,
                                 EPF_UPDATE_SATURATED};
    const epf_lsb_t lsb = {1.0f, 1.0f, z_max / 1e4f, 1.0f};
    gains->variant = fixed_variants[i];
    gains->units = ldexp(1.0, z_shift - 8);
    TEST_ASSERT_EQUAL_INT(EPF_OK, gains->variant->coeffs_init(&gains->coeffs, &params, &lsb));
    TEST_ASSERT_EQUAL_INT(z_shift, gains->variant->lengths(&gains->coeffs).z_shift);
}

/* For 24 bits of mantissa and every exponent that is accepted, at both ends of z_shift */
static void with_every_gain(void (*check)(const gains_t *, double gain), bool is_damping)
{
    static const float mantissas[] = {0.50000006f, 0.6f, 0.75f, 0.99999994f};
    for (int k = 0; k < FIXED_VARIANTS * 2 * 4; k++) {
        for (int exponent = -80; exponent <= 24; exponent += EPF_TEST_ONE_IN > 1 ? 13 : 1) {
            const float gain = ldexpf(mantissas[k / 4], exponent);
            gains_t gains;
            use_gains(&gains, k % 2, k / 2 % 2 * 29, is_damping ? 0.0f : gain,
                      is_damping ? gain : 0.0f);
            check(&gains, (double)gain);
        }
    }
}

static bool is_q15(const gains_t *gains)
{
    return gains->variant == &q15_variant;
}

/* Every length of number up to `largest`, and its neighbours in between */
static uint32_t longer(uint32_t x, uint32_t largest)
{
    return x >= largest - x / 3 - 1 ? (x < largest ? largest : 0) : x + x / 3 + 1;
}

static double viscous_error[FIXED_VARIANTS], damping_error[FIXED_VARIANTS]; /* relative */
static double least_saturation = 1e30;

/* Rounded towards zero to 2 units and the precision of the gain, up to where it saturates: from then on
   the same, at 2^27 to 2^28 */
static void viscous_term_is_accurate(const gains_t *gains, double gain)
{
    static const double precision[] = {1.0 / 4194304.0, 1.0 / 16384.0};
    const uint32_t largest = (uint32_t)gains->variant->signal_max + 1u;
    const uint32_t most = gains->variant->viscous_term(&gains->coeffs, largest);
    TEST_ASSERT_TRUE(most <= 268435456u);
    for (uint32_t speed = 1; speed != 0; speed = longer(speed, largest)) {
        const double exact = gain * gains->units * speed;
        const uint32_t term = gains->variant->viscous_term(&gains->coeffs, speed);
        TEST_ASSERT_TRUE((double)term <= exact);
        if (exact - term <= 2.0 + exact * precision[is_q15(gains)]) {
            keep_larger(&viscous_error[is_q15(gains)], (exact - term - 2.0) / exact);
        } else {
            TEST_ASSERT_TRUE(term == most && term >= 134217728u);
            least_saturation = fmin(least_saturation, term);
        }
    }
}

static void test_viscous_term_is_rounded_towards_zero_and_within_2_units_and_its_precision(void)
{
    with_every_gain(viscous_term_is_accurate, false);
    printf("viscous term, beyond 2 units: q31 within %.2g, q15 within %.2g; saturates at 2^%.2f "
           "units or more\n",
           viscous_error[0], viscous_error[1], log2(least_saturation));
}

static void damping_term_is_accurate(const gains_t *gains, double gain)
{
    static const double precision[] = {1.0 / 4194304.0, 1.0 / 4096.0};
    const double most = 536870912.0; /* 2^29 */
    for (uint32_t dt = 1; dt != 0; dt = longer(dt, gains->variant->time_max)) {
        for (uint32_t dz = 1; dz != 0; dz = longer(dz, 1879048190u)) { /* 2 z_max */
            const double exact = gain * dz / dt / 256.0;
            const double term = gains->variant->damping_term(&gains->coeffs, dz, dt);
            TEST_ASSERT_TRUE(term <= exact && term <= most);
            const double missing = fmin(exact, most) - term;
            keep_larger(&damping_error[is_q15(gains)], (missing - 4.0) / exact);
            TEST_ASSERT_TRUE(missing <= 4.0 + exact * precision[is_q15(gains)]);
        }
    }
}

static void test_damping_term_is_rounded_towards_zero_and_within_4_units_and_its_precision(void)
{
    with_every_gain(damping_term_is_accurate, true);
    printf("damping term, beyond 4 units: q31 within %.2g, q15 within %.2g\n", damping_error[0],
           damping_error[1]);
}

/* ---- the output ------------------------------------------------------------------------------ */

static double output_error[FIXED_VARIANTS];

static void output_is_rounded(const gains_t *gains, double weight, int32_t z, int32_t terms)
{
    const double exact = (z + 256.0 * terms) * weight;
    const double largest = gains->variant->signal_max;
    const int32_t force = gains->variant->in_lsb(&gains->coeffs, z, terms);
    TEST_ASSERT_TRUE((double)force * exact >= 0.0);
    TEST_ASSERT_EQUAL_INT32(-force, gains->variant->in_lsb(&gains->coeffs, -z, -terms));
    const double error = fabs(force - fmax(-largest, fmin(largest, exact)));
    const double itself = is_q15(gains) ? 0.0 : 4e-7 * fmin(largest, fabs(exact));
    keep_larger(&output_error[is_q15(gains)], error - itself);
    TEST_ASSERT_TRUE(error <= itself + (is_q15(gains) ? 1.6 : 0.5));
}

static void output_is_rounded_over_all_forces(int i, int z_shift, float f_max)
{
    const float z_max = ldexpf(1.75f, 29 - z_shift);
    const epf_params_t params = {1.0f,
                                 0.0f,
                                 0.0f,
                                 0.75f * z_max,
                                 z_max,
                                 1.0f,
                                 0.6f * z_max,
                                 EPF_STRIBECK_COULOMB,
                                 EPF_UPDATE_SATURATED};
    const epf_lsb_t lsb = {1.0f, 1.0f, z_max / f_max, 1.0f};
    gains_t gains = {.variant = fixed_variants[i]};
    TEST_ASSERT_EQUAL_INT(EPF_OK, gains.variant->coeffs_init(&gains.coeffs, &params, &lsb));
    const double weight = ldexp(1.0, -z_shift) / (double)lsb.f;
    uint32_t random = 1;
    for (int k = 0; k < EFFORT(4000); k++) {
        const int32_t z = (int32_t)random_below(&random, 939524095u) >> random_below(&random, 30);
        const int32_t terms =
            (int32_t)random_below(&random, 1073741825u) >> random_below(&random, 31);
        output_is_rounded(&gains, weight, z, 0);
        output_is_rounded(&gains, weight, z, terms);
        output_is_rounded(&gains, weight, z, -terms);
    }
    output_is_rounded(&gains, weight, 939524095, 1073741824);
    output_is_rounded(&gains, weight, 0, 0);
    output_is_rounded(&gains, weight, 1, 0);
    output_is_rounded(&gains, weight, 256, -1);
    /* and where it saturates, to the last unit */
    const double edge = gains.variant->signal_max / weight / 256.0;
    for (int32_t z = -600; z <= 600 && edge < 1e9; z++) {
        output_is_rounded(&gains, weight, z, (int32_t)edge);
    }
}

static void test_output_is_rounded_to_the_nearest_within_its_precision(void)
{
    static const float largest[] = {2147483520.0f, 32767.0f};
    for (int i = 0; i < FIXED_VARIANTS; i++) {
        for (int j = 0; powf(1.9f, (float)j) < largest[i]; j++) {
            output_is_rounded_over_all_forces(i, 0, powf(1.9f, (float)j));
            output_is_rounded_over_all_forces(i, 29, powf(1.9f, (float)j));
        }
        output_is_rounded_over_all_forces(i, 0, ldexpf(1.75f, i == 0 ? 28 : 14)); /* 2^-1, 2^-15 */
        output_is_rounded_over_all_forces(i, 0, largest[i]);
        output_is_rounded_over_all_forces(i, 29, largest[i]);
    }
    printf("output: q31 within %.3f lsb.f and 4e-7 of itself, q15 within %.3f lsb.f\n",
           output_error[0], output_error[1]);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_step_is_as_accurate_as_promised);
    RUN_TEST(test_mean_value_rule_is_many_times_closer_to_the_continuous_model);
    RUN_TEST(test_alpha_is_a_half_period_of_a_sine_from_z_ba_to_z_ss);
    RUN_TEST(test_viscous_term_is_rounded_towards_zero_and_within_2_units_and_its_precision);
    RUN_TEST(test_damping_term_is_rounded_towards_zero_and_within_4_units_and_its_precision);
    RUN_TEST(test_output_is_rounded_to_the_nearest_within_its_precision);
    return UNITY_END() != 0;
}
