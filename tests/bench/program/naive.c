/* SPDX-License-Identifier: MIT */
#include "naive.h"

#include <math.h>

float naive_f_ss(const epf_params_t *p, float v)
{
    const float ratio = v / p->v_s;
    if (v == 0.0f) {
        return p->f_max;
    }
    switch (p->stribeck) {
    case EPF_STRIBECK_COULOMB:
        return p->f_c;
    case EPF_STRIBECK_GAUSSIAN:
        return (p->f_max - p->f_c) * expf(-ratio * ratio) + p->f_c;
    case EPF_STRIBECK_LORENTZIAN:
    default:
        return (p->f_max - p->f_c) / (1.0f + ratio * ratio) + p->f_c;
    }
}

float naive_alpha(float zeta, float z_ba, float z_ss)
{
    if (zeta <= z_ba) {
        return 0.0f;
    }
    if (zeta >= z_ss) {
        return 1.0f;
    }
    return 0.5f + 0.5f * sinf(3.14159265f * ((zeta - z_ba) / (z_ss - z_ba) - 0.5f));
}

/* The pseudo-code with the direction of dx divided out: as printed it fails for v < 0 and v = 0 */
float naive_step(naive_t *contact, float dx, float v, float dt)
{
    const epf_params_t *p = contact->params;
    const float s = dx > 0.0f ? 1.0f : dx < 0.0f ? -1.0f : 0.0f;
    const float z_before = contact->z;

    if (s != 0.0f) {
        const float zeta = s * z_before;
        const float z_ss = naive_f_ss(p, v) / p->sigma_0;
        const float moved = zeta + (1.0f - naive_alpha(zeta, p->z_ba, z_ss) * zeta / z_ss) * s * dx;
        contact->z = s * (zeta < z_ss && moved < z_ss ? moved : z_ss); /* (12), (13) */
    }
    return p->sigma_0 * contact->z + p->sigma_1 * (contact->z - z_before) / dt +
           p->sigma_2 * (s != 0.0f ? s * fabsf(v) : v); /* (14) */
}
