/* SPDX-License-Identifier: MIT */
/**
 * @file fixed.h
 * What the two fixed-point variants share: the integer signals and their weights, the coefficients,
 * and the state of a contact. Include q31.h or q15.h; read this page for the numbers.
 *
 * Signals are plain integers in units that the user gives as an epf_lsb_t: encoder counts, counts
 * per second, timer ticks, DAC or PWM or millinewton units. Nothing is scaled by the user.
 *
 *     signal         unit                                  held as
 *     dx, v, f, dt   lsb.x, lsb.v, lsb.f, lsb.t            int32_t or int16_t, dt unsigned
 *     z              u = lsb.x 2^-z_shift                  int32_t, |z| <= z_max < 2^30
 *     force inside   sigma_0 u, and 2^8 of them            z + 2^8 rest: sigma_0 z is exact
 *
 * z_shift is the largest that keeps z_max within 2^30 u. A displacement thus enters the state by a
 * shift, exactly, and in the elastic regime it leaves it exactly: there is no drift, for ever.
 * In SI units z is z lsb.x 2^-z_shift metres.
 *
 * Choosing the weights. lsb.x is what the encoder gives. lsb.v well below v_s, v_s/100 say: a speed
 * that rounds to 0 counts as rest, where z_ss = f_max/sigma_0. For q15, lsb.f of f_max/16000 leaves
 * room for the damping and viscous terms, and lsb.x of z_max/16000 or coarser lets every displacement
 * short of 2 z_max fit 16 bits. Saturate what does not fit its type, a displacement or a velocity, or
 * a dt beyond the range of the timer; never let it wrap.
 */
#ifndef EPF_FIXED_H
#define EPF_FIXED_H

#include "epf/params.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#ifdef __cplusplus
}
#endif

#endif
