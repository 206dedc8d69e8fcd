/* SPDX-License-Identifier: MIT */
/* Coefficients of the fixed-point variants, made at start-up: the only floating point they have. */
#include "epf/detail/constants.h"
#include "epf/q15.h"
#include "epf/q31.h"

#include "ieee.h"

#include <stddef.h>

/*
 * The text of the macros serves here too. What is a repeated expression in a constant is a function
 * at run time; a test compares the two.
 */
static int exponent(float x)
{
    int n = -32;
    float power = 1.0f / 2147483648.0f; /* 2^(n + 1) */
    while (n < 31 && x >= power) {
        power *= 2.0f;
        n++;
    }
    return n;
}

static float power_of_two(int n)
{
    float power = 1.0f;
    for (int i = 0; i < n; i++) {
        power *= 2.0f;
    }
    return power;
}

#undef EPF_EXPONENT_
#undef EPF_POWER_
#define EPF_EXPONENT_(x) exponent(x)
#define EPF_POWER_(n)    power_of_two(n)

/* What coefficients are derived from, lengths in counts, see EPF_Q31_DERIVE_ */
typedef struct {
    float z_max, z_c, z_ba, v_s_inverse, viscous, damping, f_max;
    int z_shift;
} quantities_t;

static quantities_t quantities_of(const epf_params_t *p, const epf_lsb_t *lsb)
{
    const float z_max = EPF_COUNTS_(p->f_max, p->sigma_0, lsb->x);
    return (quantities_t){z_max,
                          EPF_COUNTS_(p->f_c, p->sigma_0, lsb->x),
                          p->z_ba / lsb->x,
                          EPF_V_S_INVERSE_(p->v_s, lsb->v),
                          EPF_VISCOUS_(p->sigma_2, p->sigma_0, lsb->x, lsb->v),
                          EPF_DAMPING_(p->sigma_1, p->sigma_0, lsb->t),
                          p->f_max / lsb->f,
                          EPF_Z_SHIFT_(z_max)};
}

static epf_status_t check(const quantities_t *q, const epf_lsb_t *lsb, float largest_force)
{
    if (!EPF_LSB_X_OK_(lsb->x, q->z_max, q->z_c, q->z_ba, q->z_shift)) {
        return EPF_ERR_LSB_X;
    }
    if (!EPF_LSB_V_OK_(lsb->v, q->v_s_inverse, q->viscous)) {
        return EPF_ERR_LSB_V;
    }
    if (!EPF_LSB_F_OK_(lsb->f, q->f_max, largest_force)) {
        return EPF_ERR_LSB_F;
    }
    return EPF_LSB_T_OK_(lsb->t, q->damping) ? EPF_OK : EPF_ERR_LSB_T;
}

static epf_status_t derive(quantities_t *q, const void *coeffs, const epf_params_t *params,
                           const epf_lsb_t *lsb, float largest_force)
{
    if (coeffs == NULL || lsb == NULL) {
        return EPF_ERR_NULL;
    }
    const epf_status_t status = epf_params_check(params);
    if (status != EPF_OK) {
        return status;
    }
    *q = quantities_of(params, lsb);
    return check(q, lsb, largest_force);
}

epf_status_t epf_q31_coeffs_init(epf_q31_coeffs_t *coeffs, const epf_params_t *params,
                                 const epf_lsb_t *lsb)
{
    quantities_t q;
    const epf_status_t status = derive(&q, coeffs, params, lsb, EPF_Q31_LARGEST_);
    if (status == EPF_OK) {
        *coeffs = (epf_q31_coeffs_t)EPF_Q31_DERIVE_(q.z_max, q.z_c, q.z_ba, q.v_s_inverse,
                                                    q.viscous, q.damping, q.f_max, params->stribeck,
                                                    params->update, q.z_shift);
    }
    return status;
}

epf_status_t epf_q15_coeffs_init(epf_q15_coeffs_t *coeffs, const epf_params_t *params,
                                 const epf_lsb_t *lsb)
{
    quantities_t q;
    const epf_status_t status = derive(&q, coeffs, params, lsb, EPF_Q15_LARGEST_);
    if (status == EPF_OK) {
        *coeffs = (epf_q15_coeffs_t)EPF_Q15_DERIVE_(q.z_max, q.z_c, q.z_ba, q.v_s_inverse,
                                                    q.viscous, q.damping, q.f_max, params->stribeck,
                                                    params->update, q.z_shift);
    }
    return status;
}
