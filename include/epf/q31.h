/* SPDX-License-Identifier: MIT */
/**
 * @file q31.h
 * The estimator on 32-bit integer signals, in units that the user gives (see fixed.h).
 */
#ifndef EPF_Q31_H
#define EPF_Q31_H

#include "epf/fixed.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef epf_fixed_coeffs_t epf_q31_coeffs_t;
typedef epf_fixed_t epf_q31_t;

#define EPF_Q31_COEFFS(...) EPF_FIXED_COEFFS_(EPF_Q31_LARGEST_, __VA_ARGS__)

epf_status_t epf_q31_coeffs_init(epf_q31_coeffs_t *coeffs, const epf_params_t *params,
                                 const epf_lsb_t *lsb);
void epf_q31_init(epf_q31_t *ep, const epf_q31_coeffs_t *coeffs);
void epf_q31_reset(epf_q31_t *ep, int32_t z);
int32_t epf_q31_fss(const epf_q31_coeffs_t *coeffs, int32_t v);
int32_t epf_q31_alpha(const epf_q31_coeffs_t *coeffs, int32_t z, int32_t v);
void epf_q31_set_velocity(epf_q31_t *ep, int32_t v);
int32_t epf_q31_advance(epf_q31_t *ep, int32_t dx);
int32_t epf_q31_update(epf_q31_t *ep, int32_t dx, int32_t v);
int32_t epf_q31_force(epf_q31_t *ep, uint32_t dt);
int32_t epf_q31_step(epf_q31_t *ep, int32_t dx, int32_t v, uint32_t dt);
int32_t epf_q31_output(const epf_q31_t *ep);
int32_t epf_q31_z(const epf_q31_t *ep);

#ifdef __cplusplus
}
#endif

#endif
