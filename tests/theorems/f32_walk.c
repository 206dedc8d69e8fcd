/* SPDX-License-Identifier: MIT */
#include "f32_walk.h"

#include "effort.h"
#include "parameter_sets.h"
#include "unity.h"

#include <math.h>
#include <stdio.h>

static const float sigma_1_over_limit[] = {0.5f, 1e4f};

float f32_from_double(double x)
{
    return x > (double)FLT_MAX ? INFINITY : x < -(double)FLT_MAX ? -INFINITY : (float)x;
}

void f32_check(const f32_step_t *step, bool condition, const char *claim)
{
    if (condition) {
        return;
    }
    static char message[320];
    (void)snprintf(message, sizeof message,
                   "%s: %s, %s, step %u: dx %g v %g dt %g z %.9g -> %.9g, z_ss %.9g, force %.9g",
                   claim, step->contact, sequence_name(step->sequence), step->index,
                   (double)step->dx, (double)step->v, (double)step->dt, (double)step->z_before,
                   (double)step->z, (double)step->z_ss, (double)step->force);
    TEST_FAIL_MESSAGE(message);
}

static void take(epf_f32_t *ep, f32_step_t *step, sample_t sample)
{
    const double z_max = (double)step->coeffs->z_max;
    step->dx = f32_from_double(sample.dx * z_max);
    step->v = f32_from_double(sample.v * (double)step->params->v_s);
    step->dt = (float)sample.dt;

    step->z_before = epf_f32_z(ep);
    step->force = epf_f32_step(ep, step->dx, step->v, step->dt);
    step->z = epf_f32_z(ep);

    step->s = step->dx > 0.0f ? 1.0f : step->dx < 0.0f ? -1.0f : 0.0f;
    step->d = fabsf(step->dx);
    step->zeta_before = step->s * step->z_before;
    step->zeta = step->s * step->z;
    step->z_ss = ep->points[ep->published].z_ss;
}

static void walk_contact(const parameter_set_t *set, float sigma_1_factor, unsigned samples,
                         f32_visitor_t visit)
{
    epf_params_t params = set->params;
    const float limit = epf_sigma_1_limit(&params, 0.0f, 1e-3f);
    if (isfinite(limit)) {
        params.sigma_1 = sigma_1_factor * limit;
    }
    epf_f32_coeffs_t coeffs;
    TEST_ASSERT_EQUAL_INT_MESSAGE(EPF_OK, epf_f32_coeffs_init(&coeffs, &params), set->name);

    for (int kind = 0; kind < SEQUENCE_KINDS; kind++) {
        f32_step_t step = {.contact = set->name,
                           .sequence = (sequence_kind_t)kind,
                           .params = &params,
                           .coeffs = &coeffs};
        sequence_t sequence;
        sequence_start(&sequence, step.sequence, 1u + (uint32_t)kind);
        epf_f32_t ep;
        epf_f32_init(&ep, &coeffs);
        for (step.index = 0; step.index < EFFORT_OF_WALK(samples); step.index++) {
            take(&ep, &step, sequence_next(&sequence));
            visit(&step);
        }
    }
}

void f32_walk(unsigned samples, f32_visitor_t visit)
{
    for (int i = 0; i < PARAMETER_SETS * 2; i += EFFORT_CONTACTS_ONE_IN) {
        walk_contact(&parameter_sets[i / 2], sigma_1_over_limit[i % 2], samples, visit);
    }
}
