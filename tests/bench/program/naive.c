/* SPDX-License-Identifier: MIT */
#include "naive.h"

#include "model.h"

#include <math.h>

/* The pseudo-code with the direction of dx divided out: as printed it fails for v < 0 and v = 0 */
float naive_step(naive_t *contact, float dx, float v, float dt)
{
    const epf_params_t *p = contact->params;
    const float s = dx > 0.0f ? 1.0f : dx < 0.0f ? -1.0f : 0.0f;
    const float z_before = contact->z;

    if (s != 0.0f) {
        const float zeta = s * z_before;
        const float z_ss = f_ss(p, v) / p->sigma_0;
        const float moved = zeta + (1.0f - alpha(zeta, p->z_ba, z_ss) * zeta / z_ss) * s * dx;
        contact->z = s * (zeta < z_ss && moved < z_ss ? moved : z_ss); /* (12), (13) */
    }
    return p->sigma_0 * contact->z + p->sigma_1 * (contact->z - z_before) / dt +
           p->sigma_2 * (s != 0.0f ? s * fabsf(v) : v); /* (14) */
}
