/* SPDX-License-Identifier: MIT */
#include "f32_step.h"

#include <math.h>
#include <stdio.h>

void f32_step_take(f32_step_t *step, epf_f32_t *ep)
{
    step->before = *ep;
    step->z_before = epf_f32_z(ep);
    step->force = epf_f32_step(ep, step->dx, step->v, step->dt);
    step->after = *ep;
    step->z = epf_f32_z(ep);

    step->s = step->dx > 0.0f ? 1.0f : step->dx < 0.0f ? -1.0f : 0.0f;
    step->d = fabsf(step->dx);
    step->zeta_before = step->s * step->z_before;
    step->zeta = step->s * step->z;
    step->z_ss = ep->points[ep->published].z_ss;
}

void f32_step_describe(const f32_step_t *step, const char *claim, char text[F32_STEP_TEXT])
{
    (void)snprintf(text, F32_STEP_TEXT,
                   "%s: %s, rule %d, %s, step %u: dx %.9g v %.9g dt %g z %.9g%+.9g -> %.9g%+.9g, "
                   "z_ss %.9g, z_ba %.9g, force %.9g",
                   claim, step->contact, (int)step->coeffs->update, step->sequence, step->index,
                   (double)step->dx, (double)step->v, (double)step->dt, (double)step->z_before,
                   (double)step->before.z_low, (double)step->z, (double)step->after.z_low,
                   (double)step->z_ss, (double)step->coeffs->z_ba, (double)step->force);
}
