/* SPDX-License-Identifier: MIT */
#include "fixed_walk.h"

#include "effort.h"
#include "parameter_sets.h"
#include "unity.h"

#include <math.h>
#include <stdio.h>

const fixed_variant_t *const fixed_variants[FIXED_VARIANTS] = {&q31_variant, &q15_variant};

void fixed_check(const fixed_step_t *step, bool condition, const char *claim)
{
    if (condition) {
        return;
    }
    static char message[360];
    (void)snprintf(
        message, sizeof message,
        "%s: %s, %s, %s, step %u: dx %ld v %ld dt %lu z %ld -> %ld, z_ss %ld, force %ld, "
        "internal %.0f",
        claim, step->variant->name, step->contact, sequence_name(step->sequence), step->index,
        (long)step->dx, (long)step->v, (unsigned long)step->dt, (long)step->z_before, (long)step->z,
        (long)step->z_ss, (long)step->force, (double)step->internal_force);
    TEST_FAIL_MESSAGE(message);
}

/* Nearest integer within the range of the type. Infinite samples reach the most negative number. */
static int32_t saturated(double x, double largest)
{
    return (int32_t)fmax(-largest - 1.0, fmin(largest, rint(x)));
}

/* An encoder counts positions: what a step leaves over comes with the next one */
static int32_t counted(double dx, double largest, double *left_over)
{
    const double wanted = dx + *left_over;
    const int32_t counts = saturated(wanted, largest);
    const double rest = wanted - (double)counts;
    *left_over = fabs(rest) <= 0.5 ? rest : 0.0;
    return counts;
}

static void take(epf_fixed_t *ep, fixed_step_t *step, sample_t sample, double *left_over)
{
    const fixed_variant_t *variant = step->variant;
    const epf_fixed_coeffs_t *c = step->coeffs;
    const double z_max = (double)c->z_max / (double)(1L << c->z_shift);
    step->dx = counted(sample.dx * z_max, variant->signal_max, left_over);
    step->v = saturated(sample.v * (double)(step->params->v_s / step->lsb->v), variant->signal_max);
    step->dt = (uint32_t)fmin(variant->time_max, sample.dt / (double)step->lsb->t);

    step->z_before = ep->z;
    step->force = variant->step(ep, step->dx, step->v, step->dt);
    step->z = ep->z;
    step->internal_force = variant->internal_force(ep, step->dt);

    step->s = (step->dx > 0) - (step->dx < 0);
    step->d = step->s * step->dx * (1LL << c->z_shift);
    step->zeta_before = step->s * step->z_before;
    step->zeta = step->s * step->z;
    step->z_ss = ep->points[ep->published].z_ss;
}

void fixed_walk_contact(const fixed_variant_t *variant, const char *contact,
                        const epf_params_t *params, const epf_lsb_t *lsb, unsigned samples,
                        fixed_visitor_t visit)
{
    epf_fixed_coeffs_t coeffs;
    TEST_ASSERT_EQUAL_INT_MESSAGE(EPF_OK, variant->coeffs_init(&coeffs, params, lsb), contact);
    for (int kind = 0; kind < SEQUENCE_KINDS; kind++) {
        fixed_step_t step = {.variant = variant,
                             .contact = contact,
                             .sequence = (sequence_kind_t)kind,
                             .params = params,
                             .lsb = lsb,
                             .coeffs = &coeffs};
        sequence_t sequence;
        sequence_start(&sequence, step.sequence, 1u + (uint32_t)kind);
        epf_fixed_t ep;
        variant->init(&ep, &coeffs);
        double left_over = 0.0;
        for (step.index = 0; step.index < EFFORT_OF_WALK(samples); step.index++) {
            take(&ep, &step, sequence_next(&sequence), &left_over);
            visit(&step);
        }
    }
}

/* Counts within z_ba: a coarse encoder, an ordinary one, a fine one */
static const float counts_in_z_ba[] = {1.0f, 13.7f, 2000.0f};
static const float sigma_1_over_limit[] = {0.5f, 300.0f};

enum { CASES = 3 * 2 }; /* all pairs of these */

static void walk_case(const fixed_variant_t *variant, const parameter_set_t *set, int i,
                      unsigned samples, fixed_visitor_t visit)
{
    epf_params_t params = set->params;
    const float limit = epf_sigma_1_limit(&params, 0.0f, 1e-3f);
    if (isfinite(limit)) {
        params.sigma_1 = sigma_1_over_limit[i / 3] * limit;
    }
    const float f_lsbs = variant == &q31_variant ? 1e8f : 2e4f;
    const float finest = params.f_max / params.sigma_0 / 1e9f; /* z_max fits 2^30 counts */
    const epf_lsb_t lsb = {fmaxf(params.z_ba / counts_in_z_ba[i % 3], finest), params.v_s / 150.0f,
                           params.f_max / f_lsbs, 1e-5f};
    fixed_walk_contact(variant, set->name, &params, &lsb, samples, visit);
}

void fixed_walk(unsigned samples, fixed_visitor_t visit)
{
    for (int i = 0; i < FIXED_VARIANTS; i++) {
        for (int j = 0; j < PARAMETER_SETS * CASES; j += EFFORT_CONTACTS_ONE_IN) {
            walk_case(fixed_variants[i], &parameter_sets[j / CASES], j % CASES, samples, visit);
        }
    }
}
