/* SPDX-License-Identifier: MIT */
/**
 * @file q15.h
 * The estimator on 16-bit integer signals, in units that the user gives (see fixed.h).
 */
#ifndef EPF_Q15_H
#define EPF_Q15_H

#include "epf/fixed.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef epf_fixed_coeffs_t epf_q15_coeffs_t;
typedef epf_fixed_t epf_q15_t;

#define EPF_Q15_COEFFS(...) EPF_FIXED_COEFFS_(EPF_Q15_LARGEST_, __VA_ARGS__)

epf_status_t epf_q15_coeffs_init(epf_q15_coeffs_t *coeffs, const epf_params_t *params,
                                 const epf_lsb_t *lsb);
void epf_q15_init(epf_q15_t *ep, const epf_q15_coeffs_t *coeffs);
void epf_q15_reset(epf_q15_t *ep, int32_t z);
int16_t epf_q15_fss(const epf_q15_coeffs_t *coeffs, int16_t v);
int32_t epf_q15_alpha(const epf_q15_coeffs_t *coeffs, int32_t z, int16_t v);
void epf_q15_set_velocity(epf_q15_t *ep, int16_t v);
int32_t epf_q15_advance(epf_q15_t *ep, int16_t dx);
int32_t epf_q15_update(epf_q15_t *ep, int16_t dx, int16_t v);
int16_t epf_q15_force(epf_q15_t *ep, uint16_t dt);
int16_t epf_q15_step(epf_q15_t *ep, int16_t dx, int16_t v, uint16_t dt);
int16_t epf_q15_output(const epf_q15_t *ep);
int32_t epf_q15_z(const epf_q15_t *ep);

#ifdef __cplusplus
}
#endif

#endif
