/* SPDX-License-Identifier: MIT */
#include <epf/q31.h>

#include "integer.h"

#define EPF(name)      epf_q31_##name
#define MAKE(made, of) epf_q31_coeffs_init(made, &(of)->params, &(of)->lsb)
#define Z(si)          to_deflection((si) / lsb->x, coeffs.z_shift)
#define X(si)          to_signal((si) / lsb->x, INT32_MIN, INT32_MAX)
#define V(si)          to_signal((si) / lsb->v, INT32_MIN, INT32_MAX)
#define T(si)          to_ticks((si) / lsb->t, UINT32_MAX)
#define DEFLECTION     int32_t
#define SIGNAL         int32_t
#define TIME           uint32_t
#define CONTACTS       wide_contacts
#include "variant.h"
