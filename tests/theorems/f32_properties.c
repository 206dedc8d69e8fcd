/* SPDX-License-Identifier: MIT */
#include "f32_properties.h"

#include <math.h>

static double exact_z(const epf_f32_t *ep)
{
    return (double)ep->z + (double)ep->z_low;
}

static double exact_before(const f32_step_t *step)
{
    return (double)step->s * exact_z(&step->before);
}

static double exact_after(const f32_step_t *step)
{
    return (double)step->s * exact_z(&step->after);
}

static bool is_saturated(const f32_step_t *step)
{
    return step->coeffs->update == EPF_UPDATE_SATURATED;
}

/* One rounding of z, and of the gap where that closed */
static double resolution(const f32_step_t *step)
{
    const double precision = step->zeta == step->z_ss ? 0x1p-22 : 0x1p-46;
    return precision * (double)step->coeffs->z_max + 0x1p-149;
}

/* A rule may make more of dx than there is, by its roundings */
void f32_rises_by_no_more_than_the_displacement(const f32_step_t *step)
{
    const double before = exact_before(step), after = exact_after(step), d = (double)step->d;
    if (step->s == 0.0f || before >= (double)step->z_ss) {
        return;
    }
    const double dz = (double)(step->s * step->after.dz);
    const double most = d * (1.0 + (double)FLT_EPSILON) + resolution(step);
    f32_check(step, after >= before, "zeta' >= zeta");
    f32_check(step, after <= (double)step->z_ss, "zeta' <= z_ss");
    f32_check(step, after - before <= most + resolution(step), "zeta' - zeta <= d");
    f32_check(step, dz >= 0.0 && dz <= most, "0 <= dz <= d");
}

void f32_is_elastic_up_to_z_ba(const f32_step_t *step)
{
    const double z_ba = (double)step->coeffs->z_ba, end = exact_before(step) + (double)step->d;
    if (step->s == 0.0f) {
        return;
    }
    if (end < z_ba) {
        const double moved = exact_after(step) - exact_before(step);
        f32_check(step, step->after.dz == step->dx, "below z_ba dz = dx, to the bit");
        f32_check(step, fabs(moved - (double)step->d) <= resolution(step), "zeta' = zeta + d");
    } else {
        f32_check(step, exact_after(step) >= z_ba - 0x1p-22 * (double)step->coeffs->z_max,
                  "zeta' >= z_ba");
    }
}

void f32_lets_go_from_above_z_ss(const f32_step_t *step)
{
    const double before = exact_before(step), after = exact_after(step);
    const double z_ss = (double)step->z_ss;
    if (step->s == 0.0f || before < z_ss) {
        return;
    }
    f32_check(step, after <= before, "above z_ss not away from it");
    f32_check(step, after >= z_ss, "above z_ss not beyond it");
    f32_check(step, !is_saturated(step) || after == z_ss, "at once, by the rule of the paper");
}

/* Beyond z_ba at least 0.35 d/z_ss of the distance to z_ss goes, or all of it: what exp(-d/z_ss) leaves of
   it, but for the length of the step */
void f32_gap_closes(const f32_step_t *step)
{
    const double before = exact_before(step), z_ss = (double)step->z_ss;
    if (step->s == 0.0f || !(before > (double)step->coeffs->z_ba)) {
        return;
    }
    const double gap = fabs(z_ss - before), left = fabs(z_ss - exact_after(step));
    const double least = gap * fmin(0.35 * (double)step->d / z_ss, 1.0);
    f32_check(step, gap - left >= least - resolution(step), "the distance to z_ss shrinks");
}

void f32_leap_arrives(const f32_step_t *step)
{
    if (step->s != 0.0f && step->d >= 2.0f * step->coeffs->z_max) {
        f32_check(step, step->zeta == step->z_ss && step->after.z_low == 0.0f,
                  "a displacement of 2 z_max ends in z_ss exactly");
    }
}
