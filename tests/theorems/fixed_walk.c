/* SPDX-License-Identifier: MIT */
#include "fixed_walk.h"

#include "effort.h"
#include "fixed_corners.h"
#include "integers.h"
#include "parameter_sets.h"
#include "sequences.h"
#include "unity.h"

#include <math.h>
#include <stdio.h>

void fixed_check(const fixed_step_t *step, bool condition, const char *claim)
{
    if (!condition) {
        static char message[FIXED_STEP_TEXT];
        fixed_step_describe(step, claim, message);
        TEST_FAIL_MESSAGE(message);
    }
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

static void scale(fixed_step_t *step, sample_t sample, double *left_over)
{
    const fixed_variant_t *variant = step->variant;
    const double z_max = (double)step->lengths.z_max / (double)step->lengths.unit;
    step->dx = counted(sample.dx * z_max, variant->signal_max, left_over);
    step->v = saturated(sample.v * (double)(step->params->v_s / step->lsb->v), variant->signal_max);
    step->dt = (uint32_t)fmin(variant->time_max, sample.dt / (double)step->lsb->t);
}

static void walk_sequence(fixed_step_t *step, sequence_kind_t kind, unsigned samples,
                          fixed_visitor_t visit)
{
    any_contact_t ep;
    step->variant->init(&ep, step->coeffs);
    sequence_t sequence;
    sequence_start(&sequence, kind, 1u + (uint32_t)kind);
    step->sequence = sequence_name(kind);
    double left_over = 0.0;
    for (step->index = 0; step->index < samples; step->index++) {
        scale(step, sequence_next(&sequence), &left_over);
        fixed_step_take(step, &ep);
        visit(step);
    }
}

static void start(fixed_step_t *step, any_coeffs_t *coeffs)
{
    TEST_ASSERT_EQUAL_INT_MESSAGE(
        EPF_OK, step->variant->coeffs_init(coeffs, step->params, step->lsb), step->contact);
    step->coeffs = coeffs;
    step->lengths = step->variant->lengths(coeffs);
}

void fixed_walk_contact(const fixed_variant_t *variant, const char *contact,
                        const epf_params_t *params, const epf_lsb_t *lsb, unsigned samples,
                        fixed_visitor_t visit)
{
    epf_params_t by_rule = *params;
    fixed_step_t step = {.variant = variant, .contact = contact, .params = &by_rule, .lsb = lsb};
    for (int rule = 0; rule < UPDATE_RULES; rule++) {
        any_coeffs_t coeffs;
        by_rule.update = (epf_update_t)rule;
        start(&step, &coeffs);
        for (int kind = 0; kind < SEQUENCE_KINDS; kind++) {
            walk_sequence(&step, (sequence_kind_t)kind, EFFORT_OF_WALK(samples), visit);
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

/* ---- the corners ------------------------------------------------------------------------------ */

/* Shows some steps of one contact at a corner, whose index picks which */
typedef void (*corner_walk_t)(fixed_step_t *step, int i, unsigned samples, fixed_visitor_t visit);

static void walk_corner(int way, int i, corner_walk_t walk, unsigned samples, fixed_visitor_t visit)
{
    fixed_corner_t corner;
    if (!fixed_corner(i, &corner)) {
        return;
    }
    corner.params.update = fixed_way_rule(way);
    static char name[24];
    (void)snprintf(name, sizeof name, "corner %d", i);
    any_coeffs_t coeffs;
    fixed_step_t step = {.variant = fixed_way_variant(way),
                         .contact = name,
                         .params = &corner.params,
                         .lsb = &corner.lsb};
    start(&step, &coeffs);
    TEST_ASSERT_EQUAL_INT_MESSAGE(corner.z_shift, step.lengths.z_shift, name);
    walk(&step, i, samples, visit);
}

static void walk_every_corner(corner_walk_t walk, unsigned samples, fixed_visitor_t visit)
{
    for (int way = 0; way < FIXED_WAYS; way++) {
        /* odd, so that no elastic share is left out by the stride alone */
        for (int i = 0; i < FIXED_CORNERS; i += EPF_TEST_ONE_IN | 1) {
            walk_corner(way, i, walk, samples, visit);
        }
    }
}

/* Each corner takes its turn at the sequences */
static void walk_a_sequence(fixed_step_t *step, int i, unsigned samples, fixed_visitor_t visit)
{
    walk_sequence(step, (sequence_kind_t)(i % SEQUENCE_KINDS), samples, visit);
}

void fixed_walk_corners(unsigned samples, fixed_visitor_t visit)
{
    walk_every_corner(walk_a_sequence, samples, visit);
}

/* Of every length, from 1 to bound; bound is below 2^31 */
static int32_t of_every_length(uint32_t *random, int32_t bound)
{
    const uint32_t x = random_below(random, (uint32_t)bound) >> random_below(random, 31);
    return (int32_t)x + 1;
}

/* In the direction of a motion towards +; reset() clamps it */
static int32_t scattered_state(uint32_t *random, const fixed_lengths_t *c, int32_t z_ss)
{
    switch (random_below(random, 5)) {
    case 0:
        return c->z_ba + of_every_length(random, z_ss - c->z_ba);
    case 1:
        return z_ss - of_every_length(random, z_ss);
    case 2:
        return z_ss + of_every_length(random, c->z_max);
    case 3:
        return of_every_length(random, c->z_max);
    default:
        return -of_every_length(random, c->z_max);
    }
}

static int32_t scattered_displacement(uint32_t *random, const fixed_lengths_t *c, int32_t z_ss,
                                      int32_t largest)
{
    if (random_below(random, 8) == 0) {
        const uint32_t halves = 1u + random_below(random, 9);
        const uint64_t counts = (uint64_t)z_ss * halves / 2u / c->unit;
        return (int32_t)(counts > 1u && counts < (uint32_t)largest ? counts : 1u);
    }
    return of_every_length(random, c->leap < (uint32_t)largest ? (int32_t)c->leap : largest);
}

static void scatter(fixed_step_t *step, int i, unsigned samples, fixed_visitor_t visit)
{
    const fixed_variant_t *variant = step->variant;
    any_contact_t ep;
    variant->init(&ep, step->coeffs);
    uint32_t random = (uint32_t)i + 1u;
    step->sequence = "scattered";
    for (step->index = 0; step->index < samples; step->index++) {
        const int32_t s = random_below(&random, 2) != 0 ? 1 : -1;
        step->v = of_every_length(&random, variant->signal_max) - 1;
        step->dt = random_word(&random) >> random_below(&random, 32) & variant->time_max;
        variant->set_velocity(&ep, step->v); /* the step is aimed at the z_ss of this velocity */
        const int32_t z_ss = variant->z_ss(&ep);
        variant->reset(&ep, s * scattered_state(&random, &step->lengths, z_ss));
        step->dx = s * scattered_displacement(&random, &step->lengths, z_ss, variant->signal_max);
        fixed_step_take(step, &ep);
        visit(step);
    }
}

void fixed_scatter(unsigned samples, fixed_visitor_t visit)
{
    walk_every_corner(scatter, samples, visit);
}
