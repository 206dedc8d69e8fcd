/* SPDX-License-Identifier: MIT */
#include "fixed_properties.h"

static int64_t at_most(int64_t x, int64_t bound)
{
    return x < bound ? x : bound;
}

static int64_t plastic_displacement(const fixed_step_t *step)
{
    return step->d - (step->zeta - step->zeta_before);
}

/* ---- the state ------------------------------------------------------------------------------ */

void state_is_bounded(const fixed_step_t *step)
{
    const fixed_lengths_t *c = &step->lengths;
    fixed_check(step, step->z <= c->z_max && step->z >= -c->z_max, "|z| <= z_max");
    fixed_check(step, step->z_ss >= c->z_c && step->z_ss <= c->z_max, "z_c <= z_ss <= z_max");
    fixed_check(step, step->s != 0 || step->z == step->z_before, "dx = 0 changes nothing");
}

void deflects_by_part_of_the_displacement(const fixed_step_t *step)
{
    if (step->s != 0 && step->zeta_before < step->z_ss) {
        fixed_check(step, step->zeta > step->zeta_before, "strict progress below z_ss");
        fixed_check(step, step->zeta <= at_most(step->zeta_before + step->d, step->z_ss),
                    "zeta' <= min(zeta + d, z_ss)");
    }
}

void plastic_displacement_follows_the_motion(const fixed_step_t *step)
{
    if (step->s != 0) {
        fixed_check(step, plastic_displacement(step) >= 0, "dw has the direction of the motion");
        fixed_check(step, plastic_displacement(step) == 0 || step->zeta > step->lengths.z_ba,
                    "zeta' > z_ba wherever dw is not 0");
    }
}

void elastic_displacement_is_all_deflection(const fixed_step_t *step)
{
    const int64_t elastic = step->zeta_before + step->d;
    if (step->s != 0 && elastic <= step->lengths.z_ba) {
        fixed_check(step, step->zeta == elastic, "z' = z + (dx << z_shift)");
    } else if (step->s != 0) {
        fixed_check(step, step->zeta > step->lengths.z_ba, "what is not all elastic passes z_ba");
    }
}

void approaches_steady_state_from_above(const fixed_step_t *step)
{
    if (step->s != 0 && step->zeta_before >= step->z_ss) {
        fixed_check(step, step->zeta >= step->z_ss, "zeta' >= z_ss, whence zeta was");
        fixed_check(step, step->zeta < step->zeta_before || step->zeta == step->z_ss,
                    "strict progress above z_ss, and none from there");
        fixed_check(step, step->params->update != EPF_UPDATE_SATURATED || step->zeta == step->z_ss,
                    "the paper's rule lets go at once");
    }
}

void leap_arrives(const fixed_step_t *step)
{
    if (step->d >= 2 * (int64_t)step->lengths.z_max) {
        fixed_check(step, step->zeta == step->z_ss, "d >= 2 z_max ends in z_ss");
    }
}

/* ---- the force ------------------------------------------------------------------------------ */

void force_opposes_plastic_motion(const fixed_step_t *step)
{
    if (step->s != 0 && plastic_displacement(step) != 0) {
        fixed_check(step, step->s * step->internal_force > 0, "f dw > 0");
        fixed_check(step, step->s * step->force >= 0, "f dw >= 0 for the rounded force");
    }
}

/*
 * 2 f dx > 2 (W_k - W_{k-1}) with W = z^2/2, in sigma_0 u^2. A force beyond 2^30 only adds work, and so
 * does a displacement beyond 2 z_max, where the force is along it: the product is exact in 64 bits.
 */
void no_step_yields_energy(const fixed_step_t *step)
{
    if (step->s == 0) {
        return;
    }
    const int64_t room = (int64_t)1 << 30;
    const int64_t f = at_most(step->s * step->internal_force, room);
    fixed_check(step, f > -room, "no force against the motion is larger than the elastic one");
    const int64_t d = at_most(step->d, 2 * (int64_t)step->lengths.z_max);
    fixed_check(step, d == step->d || f > 0, "the force of a leap is along the motion");
    const int64_t stored = (step->zeta - step->zeta_before) * (step->zeta + step->zeta_before);
    fixed_check(step, 2 * f * d > stored, "2 f dx > 2 (W_k - W_{k-1})");
}

void published_force_is_the_rounded_one(const fixed_step_t *step)
{
    const int32_t largest = step->variant->signal_max;
    fixed_check(step, step->variant->output(&step->after) == step->force,
                "output is what step returned");
    fixed_check(step, step->force <= largest && step->force >= -largest,
                "the most negative number is not used");
    fixed_check(step, step->internal_force >= 0 || step->force <= 0, "sign of a negative force");
    fixed_check(step, step->internal_force <= 0 || step->force >= 0, "sign of a positive force");
    fixed_check(step, step->internal_force != 0 || step->force == 0,
                "no force where there is none");
}

/* ---- the calls ------------------------------------------------------------------------------ */

static uint16_t rejected(const fixed_step_t *step, any_contact_t contact)
{
    return *step->variant->rejected(&contact);
}

void rejected_counts_times_of_0(const fixed_step_t *step)
{
    const uint16_t before = rejected(step, step->before);
    const bool counts = step->dt == 0 && before != UINT16_MAX;
    fixed_check(step, rejected(step, step->after) == before + (counts ? 1 : 0), "rejected");
}

void split_calls_leave_the_same_contact(const fixed_step_t *step)
{
    const fixed_variant_t *variant = step->variant;
    any_contact_t split = step->before;
    variant->set_velocity(&split, step->v);
    fixed_check(step, variant->advance(&split, step->dx) == step->z, "advance is part of step");
    fixed_check(step, variant->force(&split, step->dt) == step->force, "force is part of step");
    fixed_check(step, variant->same_contact(&split, &step->after),
                "split calls leave the contact as step does");
    any_contact_t update = step->before;
    fixed_check(step, variant->update(&update, step->dx, step->v) == step->z,
                "update is part of step");
    (void)variant->force(&update, step->dt);
    fixed_check(step, variant->same_contact(&update, &step->after),
                "update and force leave the contact as step does");
}

/* The image starts from the mirrored state. The most negative number has no mirror image. */
void negated_inputs_negate_outputs(const fixed_step_t *step)
{
    const fixed_variant_t *variant = step->variant;
    if (step->dx < -variant->signal_max || step->v < -variant->signal_max) {
        return;
    }
    any_contact_t image = step->before;
    variant->reset(&image, -step->z_before);
    const int32_t force = variant->step(&image, -step->dx, -step->v, step->dt);
    fixed_check(step, variant->z(&image) == -step->z, "state of the mirror image");
    fixed_check(step, force == -step->force, "force of the mirror image");
}

void fixed_check_all(const fixed_step_t *step)
{
    state_is_bounded(step);
    deflects_by_part_of_the_displacement(step);
    plastic_displacement_follows_the_motion(step);
    elastic_displacement_is_all_deflection(step);
    approaches_steady_state_from_above(step);
    leap_arrives(step);
    force_opposes_plastic_motion(step);
    no_step_yields_energy(step);
    published_force_is_the_rounded_one(step);
    rejected_counts_times_of_0(step);
    split_calls_leave_the_same_contact(step);
    negated_inputs_negate_outputs(step);
}
