/* SPDX-License-Identifier: MIT */
#include <epf/q15.h>

#include "integer.h"

#define EPF(name)    epf_q15_##name
#define COEFFS(form) EPF_Q15_COEFFS(CONTACT(form), SIGNALS)
#define MAKE(c, p)   epf_q15_coeffs_init(c, p, &(const epf_lsb_t){SIGNALS})
#define Z(si)        to_deflection(si, coeffs->z_shift)
#define X(si)        (int16_t) to_signed((si) / LSB_X, INT16_MIN, INT16_MAX)
#define V(si)        (int16_t) to_signed((si) / LSB_V, INT16_MIN, INT16_MAX)
#define T(si)        (uint16_t) to_unsigned((si) / LSB_T, UINT16_MAX)
#define RUN          run_q15
#include "variant.h"
