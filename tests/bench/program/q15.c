/* SPDX-License-Identifier: MIT */
#include <epf/q15.h>

#include "integer.h"

#define EPF(name)      epf_q15_##name
#define MAKE(made, of) epf_q15_coeffs_init(made, &(of)->params, &(of)->lsb)
#define Z(si)          to_deflection((si) / lsb->x, coeffs.z_shift)
#define X(si)          (int16_t) to_signal((si) / lsb->x, INT16_MIN, INT16_MAX)
#define V(si)          (int16_t) to_signal((si) / lsb->v, INT16_MIN, INT16_MAX)
#define T(si)          (uint16_t) to_ticks((si) / lsb->t, UINT16_MAX)
#define DEFLECTION     int32_t
#define SIGNAL         int16_t
#define TIME           uint16_t
#define CONTACTS       integer_contacts
#include "variant.h"
