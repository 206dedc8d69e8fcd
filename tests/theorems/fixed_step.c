/* SPDX-License-Identifier: MIT */
#include "fixed_step.h"

#include <stdio.h>

const fixed_variant_t *const fixed_variants[FIXED_VARIANTS] = {&q31_variant, &q15_variant};

void fixed_step_take(fixed_step_t *step, any_contact_t *ep)
{
    const fixed_variant_t *variant = step->variant;
    step->before = *ep;
    step->z_before = variant->z(ep);
    step->force = variant->step(ep, step->dx, step->v, step->dt);
    step->after = *ep;
    step->z = variant->z(ep);
    step->internal_force = variant->internal_force(ep, step->dt);

    step->s = (step->dx > 0) - (step->dx < 0);
    step->d = step->s * step->dx * (int64_t)step->lengths.unit;
    step->zeta_before = step->s * step->z_before;
    step->zeta = step->s * step->z;
    step->z_ss = variant->z_ss(ep);
}

void fixed_step_describe(const fixed_step_t *step, const char *claim, char text[FIXED_STEP_TEXT])
{
    static const char *const rules[UPDATE_RULES] = {"saturated", "mean value"};
    (void)snprintf(
        text, FIXED_STEP_TEXT,
        "%s: %s, %s, %s, %s, step %u: dx %ld v %ld dt %lu z %ld -> %ld, z_ss %ld, force %ld, "
        "internal %.0f",
        claim, step->variant->name, rules[step->params->update], step->contact, step->sequence,
        step->index, (long)step->dx, (long)step->v, (unsigned long)step->dt, (long)step->z_before,
        (long)step->z, (long)step->z_ss, (long)step->force, (double)step->internal_force);
}
