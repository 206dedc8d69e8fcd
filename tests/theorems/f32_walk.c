/* SPDX-License-Identifier: MIT */
#include "f32_walk.h"

#include "effort.h"
#include "parameter_sets.h"
#include "sequences.h"
#include "unity.h"

#include <math.h>

static const float sigma_1_over_limit[] = {0.5f, 1e4f};

#define LORENTZIAN EPF_STRIBECK_LORENTZIAN
#define GAUSSIAN   EPF_STRIBECK_GAUSSIAN
#define COULOMB    EPF_STRIBECK_COULOMB
#define SATURATED  EPF_UPDATE_SATURATED

/* sigma_0, sigma_1, sigma_2, f_c, f_max, v_s, z_ba */
static const parameter_set_t corners[] = {
    {"z_ba the float below z_c",
     {1.0f, 1.0f, 1.0f, 2.25f, 3.0f, 1e-3f, 2.24999976f, LORENTZIAN, SATURATED}},
    {"z_ba the float below z_c, f_max = 1e5 f_c",
     {1.0f, 1.0f, 0.0f, 1.0f, 1e5f, 1e-3f, 0.99999994f, GAUSSIAN, SATURATED}},
    {"f_max the float above f_c",
     {1e5f, 1e3f, 0.0f, 1.0f, 1.00000012f, 1e-3f, 8e-6f, LORENTZIAN, SATURATED}},
    {"f_max = f_c, sigma_1 huge",
     {1e5f, 1e30f, 0.0f, 1.0f, 1.0f, 1e-3f, 8e-6f, COULOMB, SATURATED}},
    {"contact of 1e-30 m", {1e30f, 1e20f, 1.0f, 1.0f, 1.5f, 1e-3f, 5e-31f, LORENTZIAN, SATURATED}},
    {"contact of 1e37 m",
     {1e-20f, 1e-10f, 1.0f, 1e17f, 2e17f, 1e-3f, 5e36f, LORENTZIAN, SATURATED}},
    {"contact of 1e-30 m, Gaussian",
     {1e30f, 1e20f, 1.0f, 1.0f, 9.0f, 1e-3f, 9e-31f, GAUSSIAN, SATURATED}},
    {"largest force", {1e36f, 1e36f, 1e36f, 1e37f, 2e37f, 1e-3f, 1.0f, LORENTZIAN, SATURATED}},
    {"smallest force", {1.0f, 1.0f, 0.0f, 1e-34f, 1.5e-34f, 1e-3f, 5e-35f, LORENTZIAN, SATURATED}},
};

enum { CORNERS = sizeof corners / sizeof corners[0] };

float f32_from_double(double x)
{
    return x > (double)FLT_MAX ? INFINITY : x < -(double)FLT_MAX ? -INFINITY : (float)x;
}

void f32_check(const f32_step_t *step, bool condition, const char *claim)
{
    if (!condition) {
        static char text[F32_STEP_TEXT];
        f32_step_describe(step, claim, text);
        TEST_FAIL_MESSAGE(text);
    }
}

static void take(epf_f32_t *ep, f32_step_t *step, sample_t sample)
{
    step->dx = f32_from_double(sample.dx * (double)step->coeffs->z_max);
    step->v = f32_from_double(sample.v * (double)step->params->v_s);
    step->dt = (float)sample.dt;
    f32_step_take(step, ep);
}

static void walk_contact(const parameter_set_t *set, epf_update_t rule, float sigma_1_factor,
                         unsigned samples, f32_visitor_t visit)
{
    epf_params_t params = parameters_by(rule, set);
    const float limit = epf_sigma_1_limit(&params, 0.0f, 1e-3f);
    if (isfinite(limit)) {
        params.sigma_1 = sigma_1_factor * limit;
    }
    epf_f32_coeffs_t coeffs;
    TEST_ASSERT_EQUAL_INT_MESSAGE(EPF_OK, epf_f32_coeffs_init(&coeffs, &params), set->name);

    for (int kind = 0; kind < SEQUENCE_KINDS; kind++) {
        f32_step_t step = {.contact = set->name,
                           .sequence = sequence_name((sequence_kind_t)kind),
                           .is_extreme = kind == SEQUENCE_EXTREMES,
                           .params = &params,
                           .coeffs = &coeffs};
        sequence_t sequence;
        sequence_start(&sequence, (sequence_kind_t)kind, 1u + (uint32_t)kind);
        epf_f32_t ep;
        epf_f32_init(&ep, &coeffs);
        for (step.index = 0; step.index < EFFORT_OF_WALK(samples); step.index++) {
            take(&ep, &step, sequence_next(&sequence));
            visit(&step);
        }
    }
}

/* Each contact by either rule and with either sigma_1 */
static void walk_contacts(const parameter_set_t *sets, int count, unsigned samples,
                          f32_visitor_t visit)
{
    for (int i = 0; i < count * 2 * UPDATE_RULES; i += EFFORT_CONTACTS_ONE_IN) {
        const epf_update_t rule = (epf_update_t)(i % UPDATE_RULES);
        const int contact = i / UPDATE_RULES;
        walk_contact(&sets[contact / 2], rule, sigma_1_over_limit[contact % 2], samples, visit);
    }
}

void f32_walk(unsigned samples, f32_visitor_t visit)
{
    walk_contacts(parameter_sets, PARAMETER_SETS, samples, visit);
}

void f32_walk_corners_too(unsigned samples, f32_visitor_t visit)
{
    f32_walk(samples, visit);
    walk_contacts(corners, CORNERS, samples, visit);
}
