/* SPDX-License-Identifier: MIT */
/* The contact that is measured: Table II of the paper, with a viscous term, so that nothing is left
   out because it is zero. */
#ifndef CONTACT_H
#define CONTACT_H

#include <epf/params.h>

#define SIGMA_0 1e5f
#define F_C     1.0f
#define F_MAX   1.5f
#define V_S     1e-3f
#define Z_BA    8e-6f
#define Z_C     (F_C / SIGMA_0)
#define Z_MAX   (F_MAX / SIGMA_0)

#define CONTACT(form) SIGMA_0, 1e3f, 0.4f, F_C, F_MAX, V_S, Z_BA, form, EPF_UPDATE_SATURATED

/* 10 nm, 1 um/s, 0.1 mN, 10 us: a leap fits 16 bits, and so does 30 v_s */
#define LSB_X   1e-8f
#define LSB_V   1e-6f
#define LSB_F   1e-4f
#define LSB_T   1e-5f
#define SIGNALS LSB_X, LSB_V, LSB_F, LSB_T

#endif
