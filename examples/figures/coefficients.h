/* SPDX-License-Identifier: MIT */
/* One friction as every variant of the library takes it, and what 1 in each of its integers weighs */
#ifndef COEFFICIENTS_H
#define COEFFICIENTS_H

#include "friction.h"

#include <epf/f32.h>
#include <epf/q15.h>
#include <epf/q31.h>

typedef struct {
    epf_f32_coeffs_t f32;
    epf_q31_coeffs_t q31;
    epf_q15_coeffs_t q15;
    epf_lsb_t lsb_q31, lsb_q15;
} coefficients_t;

/* The parameters must suit the library: what the paper gives does */
coefficients_t coefficients_of(const friction_t *friction);

#endif
