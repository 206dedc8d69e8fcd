/* SPDX-License-Identifier: MIT */
#include <epf/q31.h>

#include "integer.h"

#define EPF(name)    epf_q31_##name
#define COEFFS(form) EPF_Q31_COEFFS(CONTACT(form), SIGNALS)
#define MAKE(c, p)   epf_q31_coeffs_init(c, p, &(const epf_lsb_t){SIGNALS})
#define Z(si)        to_deflection(si, coeffs->z_shift)
#define X(si)        to_signed((si) / LSB_X, INT32_MIN, INT32_MAX)
#define V(si)        to_signed((si) / LSB_V, INT32_MIN, INT32_MAX)
#define T(si)        to_unsigned((si) / LSB_T, UINT32_MAX)
#define RUN          run_q31
#include "variant.h"
