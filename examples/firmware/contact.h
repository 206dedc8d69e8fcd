/* SPDX-License-Identifier: MIT */
/* The contact in SI units, and what one count of each signal weighs. */
#ifndef CONTACT_H
#define CONTACT_H

#include <epf/params.h>

/* sigma_0, sigma_1, sigma_2, f_c, f_max, v_s, z_ba */
#define SLIDE \
    1e5f, 15.0f, 20.0f, 1.0f, 1.5f, 1e-3f, 7e-6f, EPF_STRIBECK_LORENTZIAN, EPF_UPDATE_MEAN_VALUE

#define COUNT   1e-7f /* m, of the encoder */
#define SPEED   1e-5f /* m/s */
#define FORCE   1e-4f /* N */
#define TICK    1e-4f /* s, of the timer of the encoder */
#define SIGNALS COUNT, SPEED, FORCE, TICK

#define CONTROL_MS        1  /* period of the control interrupt */
#define TICKS_PER_CONTROL 10 /* CONTROL_MS/TICK */
#define SPEED_OF_COUNT    10 /* one COUNT in one control period, in SPEED */

#endif
