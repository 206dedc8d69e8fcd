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

#include "epf/detail/constants.h"
#include "epf/params.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A real coefficient, mantissa 2^-shift, with 2^23 <= mantissa < 2^24, or less below 2^-33; or 0. */
typedef struct {
    uint32_t mantissa;
    int8_t shift;
} epf_gain_t;

/**
 * What the estimator needs of the parameters, made once. Constant from then on: it may live in flash
 * and be shared by any number of estimators of the variant that it was made for, whose forces it
 * fits. Read it freely, change it never.
 */
typedef struct {
    int32_t z_max;           /**< f_max/sigma_0, u: no state is ever larger; 2^29 to 2^30 */
    int32_t z_c;             /**< f_c/sigma_0, u */
    int32_t z_ba;            /**< break-away deflection, u; at least one count of displacement */
    uint32_t unit;           /**< one count of displacement, u: 2^z_shift */
    uint32_t leap;           /**< the smallest displacement of 2 z_max or more, counts */
    epf_gain_t v_s_inverse;  /**< lsb.v/v_s */
    epf_gain_t viscous;      /**< viscous force of one lsb.v, 2^8 sigma_0 u */
    epf_gain_t damping;      /**< sigma_1/sigma_0, lsb.t */
    epf_gain_t output;       /**< sigma_0 u, lsb.f */
    uint8_t z_shift;         /**< 0 to 29 */
    epf_stribeck_t stribeck; /**< form of f_ss(v) */
} epf_fixed_coeffs_t;

/** All that follows from the velocity alone. Private. */
typedef struct {
    int32_t z_ss;        /* |z_ss(v)|, u */
    int32_t viscous;     /* sigma_2 v, 2^8 sigma_0 u */
    uint32_t inv_span;   /* 1/(z_ss - z_ba), as quotient() takes it */
    uint32_t span_share; /* (z_ss - z_ba)/z_ss */
    uint8_t span_zeros;  /* leading zeros of z_ss - z_ba */
} epf_fixed_point_t;

/** One contact. Allocate it anywhere, initialise it. Only `rejected` is public. */
typedef struct {
    const epf_fixed_coeffs_t *coeffs;
    int32_t z;                   /* z_k, u */
    int32_t dz;                  /* z_k - z_{k-1}, u */
    int32_t force;               /* as last published, lsb.f */
    uint16_t rejected;           /**< unusable values (dt = 0) since init; stays at UINT16_MAX */
    int8_t direction;            /* sgn(dx_k) */
    uint8_t published;           /* index of the published operating point */
    epf_fixed_point_t points[2]; /* the published one, and the one being prepared */
} epf_fixed_t;

#ifdef __cplusplus
}
#endif

#endif
