/* SPDX-License-Identifier: MIT */
/* Coefficients of the fixed-point variants, made at start-up: the only floating point they have. */
#include "kernel.h"

#include <stddef.h>

/* EPF_GAIN_, by doubling instead of comparing */
static epf_gain_t gain(float x, int power)
{
    int shift = 0;
    while (x < 8388608.0f && shift < 56) {
        x *= 2.0f;
        shift++;
    }
    return (epf_gain_t){(uint32_t)x, (int8_t)(shift - power)};
}

/* EPF_Z_SHIFT_, likewise */
static uint8_t z_shift_of(float z_max)
{
    uint8_t shift = 0;
    while (2.0f * z_max <= 1073741824.0f && shift < 30) {
        z_max *= 2.0f;
        shift++;
    }
    return shift;
}

static epf_status_t check_and_derive(epf_fixed_coeffs_t *c, const epf_params_t *p,
                                     const epf_lsb_t *lsb, float largest_force)
{
    const float z_max = EPF_COUNTS_(p->f_max, p->sigma_0, lsb->x);
    const float z_c = EPF_COUNTS_(p->f_c, p->sigma_0, lsb->x);
    const float z_ba = p->z_ba / lsb->x;
    const uint8_t z_shift = z_shift_of(z_max);
    if (!EPF_LSB_X_OK_(lsb->x, z_max, z_c, z_ba, z_shift)) {
        return EPF_ERR_LSB_X;
    }
    const float v_s_inverse = EPF_V_S_INVERSE_(p->v_s, lsb->v);
    const float viscous = EPF_VISCOUS_(p->sigma_2, p->sigma_0, lsb->x, lsb->v);
    if (!EPF_LSB_V_OK_(lsb->v, v_s_inverse, viscous)) {
        return EPF_ERR_LSB_V;
    }
    const float output = EPF_OUTPUT_(p->sigma_0, lsb->x, lsb->f);
    if (!EPF_LSB_F_OK_(lsb->f, p->f_max, output, largest_force)) {
        return EPF_ERR_LSB_F;
    }
    const float damping = EPF_DAMPING_(p->sigma_1, p->sigma_0, lsb->t);
    if (!EPF_LSB_T_OK_(lsb->t, damping)) {
        return EPF_ERR_LSB_T;
    }
    const int32_t z_max_u = EPF_UNITS_(z_max, z_shift);
    *c = (epf_fixed_coeffs_t){z_max_u,
                              EPF_UNITS_(z_c, z_shift),
                              EPF_UNITS_(z_ba, z_shift),
                              (uint32_t)1 << z_shift,
                              EPF_LEAP_(z_max_u, z_shift),
                              gain(v_s_inverse, 0),
                              gain(viscous, z_shift - 8),
                              gain(damping, 0),
                              gain(output, 8 - z_shift),
                              z_shift,
                              p->stribeck};
    return EPF_OK;
}

epf_status_t epf_fixed_coeffs_init(epf_fixed_coeffs_t *coeffs, const epf_params_t *params,
                                   const epf_lsb_t *lsb, float largest_force)
{
    if (coeffs == NULL || lsb == NULL) {
        return EPF_ERR_NULL;
    }
    const epf_status_t status = epf_params_check(params);
    return status != EPF_OK ? status : check_and_derive(coeffs, params, lsb, largest_force);
}
