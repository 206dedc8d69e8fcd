/* SPDX-License-Identifier: MIT */
/* The equations that the transcription and its rivals share; in a header, for each to have them in line. */
#ifndef MODEL_H
#define MODEL_H

#include <epf/params.h>

#include <math.h>

/* |f_ss(v)|, eqs. (6) to (8) */
static inline float f_ss(const epf_params_t *p, float v)
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

/* Eq. (10), with the factor 1/2 that its print has lost */
static inline float alpha(float zeta, float z_ba, float z_ss)
{
    if (zeta <= z_ba) {
        return 0.0f;
    }
    if (zeta >= z_ss) {
        return 1.0f;
    }
    return 0.5f + 0.5f * sinf(3.14159265f * ((zeta - z_ba) / (z_ss - z_ba) - 0.5f));
}

#endif
