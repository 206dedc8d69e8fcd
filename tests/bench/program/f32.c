/* SPDX-License-Identifier: MIT */
#include <epf/f32.h>

#define EPF(name)      epf_f32_##name
#define MAKE(made, of) epf_f32_coeffs_init(made, &(of)->params)
#define Z(si)          (si)
#define X(si)          (si)
#define V(si)          (si)
#define T(si)          (si)
#define DEFLECTION     float
#define SIGNAL         float
#define TIME           float
#define CONTACTS       float_contacts
#include "variant.h"
