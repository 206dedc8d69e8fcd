/* SPDX-License-Identifier: MIT */
#include <epf/f32.h>

#define EPF(name)    epf_f32_##name
#define COEFFS(form) EPF_F32_COEFFS(CONTACT(form))
#define MAKE(c, p)   epf_f32_coeffs_init(c, p)
#define Z(si)        (si)
#define X(si)        (si)
#define V(si)        (si)
#define T(si)        (si)
#define RUN          run_f32
#include "variant.h"
