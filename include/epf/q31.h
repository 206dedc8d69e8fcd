/* SPDX-License-Identifier: MIT */
/**
 * @file q31.h
 * The estimator on 32-bit integer signals, for cores with a 32 by 32 to 64-bit multiplication (Cortex-M3
 * and up, RV32IM); on others products are made of four. fixed.h is the manual; here stands what is
 * particular to this variant.
 */
#ifndef EPF_Q31_H
#define EPF_Q31_H

#include "epf/detail/constants.h"
#include "epf/fixed.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A gain x g = ((min(x, limit) << up) mantissa) 2^-32. Private. */
typedef struct {
    uint32_t mantissa, limit;
    uint8_t up;
} epf_q31_gain_t;

/**
 * What the estimator needs of the parameters, made once. Constant from then on: it may live in flash
 * and be shared by any number of estimators. Public: z_max, z_ba, z_shift.
 */
typedef struct {
    epf_stribeck_t stribeck; /**< form of f_ss(v) */
    epf_update_t update;     /**< update rule */
    int32_t z_max;           /**< f_max/sigma_0, u: no state is ever larger; 2^29 to 2^30 - 1 */
    int32_t z_c;             /**< f_c/sigma_0, u */
    int32_t z_ba;            /**< break-away deflection, u; at least one count of displacement */
    uint32_t unit;           /**< one count of displacement, u: 2^z_shift */
    uint32_t leap;           /**< the smallest displacement of 2 z_max or more, counts */
    epf_q31_gain_t ratio;    /**< |v| to |v|/v_s in Q20 */
    epf_q31_gain_t viscous;  /**< |v| to sigma_2 |v| in 256 sigma_0 u */
    uint32_t damping;        /**< leading bits of sigma_1/sigma_0 */
    int8_t damping_shift;    /**< and their weight, see damping_term() */
    uint32_t output;         /**< leading bits of sigma_0 u in lsb.f */
    uint8_t output_shift;    /**< sigma_0 u is output 2^-output_shift */
    uint8_t z_shift;         /**< 0 to 29 */
} epf_q31_coeffs_t;

/** All that follows from the velocity alone. Private. */
typedef struct {
    int32_t z_ss;          /* |z_ss(v)|, u */
    int32_t viscous;       /* sigma_2 v, 256 sigma_0 u */
    uint32_t span_inverse; /* 2^62/(span 2^span_zeros), span = z_ss - z_ba */
    uint32_t span_share;   /* span/z_ss in Q32 */
    uint8_t span_zeros;    /* leading zeros of the span */
} epf_q31_point_t;

/** One contact. Allocate it anywhere, initialise it by epf_q31_init. Only `rejected` is public. */
typedef struct {
    const epf_q31_coeffs_t *coeffs;
    int32_t z;                 /* z_k, u */
    int32_t dzeta;             /* s (z_k - z_{k-1}), u, s = sgn dx_k */
    int32_t force;             /* as last published, lsb.f */
    uint16_t rejected;         /**< unusable values (dt = 0) since init; stays at UINT16_MAX */
    int8_t direction;          /* sgn(dx_k) */
    uint8_t published;         /* index of the published operating point */
    epf_q31_point_t points[2]; /* the published one, and the one being prepared */
} epf_q31_t;

/**
 * Coefficients as a constant initialiser, equal to those of epf_q31_coeffs_init.
 *
 *     #define SLIDE   1e5f, 63.0f, 0.0f, 1.0f, 1.1f, 1e-5f, 8e-6f, \
 *                     EPF_STRIBECK_LORENTZIAN, EPF_UPDATE_MEAN_VALUE
 *     #define SIGNALS 1e-8f, 1e-7f, 1e-6f, 1e-6f   // 10 nm, 0.1 um/s, 1 uN, 1 us
 *     static const epf_q31_coeffs_t slide = EPF_Q31_COEFFS(SLIDE, SIGNALS);
 *
 * In C++ declare the object constexpr, or it may be made at start-up.
 */
#define EPF_Q31_COEFFS(...) EPF_FIXED_COEFFS_(EPF_Q31_DERIVE_, EPF_Q31_LARGEST_, __VA_ARGS__)

/** Makes coefficients at run time; f_max up to 2,147,483,520 lsb.f. Start-up. */
epf_status_t epf_q31_coeffs_init(epf_q31_coeffs_t *coeffs, const epf_params_t *params,
                                 const epf_lsb_t *lsb);

/** Prepares an estimator at rest. Start-up. Cost: that of epf_q31_set_velocity. */
void epf_q31_init(epf_q31_t *ep, const epf_q31_coeffs_t *coeffs);

/** Puts the state to z, in u. Displacement context. Cost: 2 products. */
void epf_q31_reset(epf_q31_t *ep, int32_t z);

/**
 * Steady-state friction f_ss(v) in lsb.f, v in lsb.v; any. Any context.
 * [2] within 5e-6 (f_max - f_c), 0.5 lsb.f and 4e-7 of itself. Cost: that of epf_q31_set_velocity at the most.
 */
int32_t epf_q31_fss(const epf_q31_coeffs_t *coeffs, int32_t v);

/**
 * alpha(z, v), eq. (10), in Q30: 2^30 is 1; z in u, v in lsb.v; any. Any context.
 * Within 1e-5 of eq. (10) for the z_ss(v) in use. Cost: that of epf_q31_set_velocity and epf_q31_advance.
 */
int32_t epf_q31_alpha(const epf_q31_coeffs_t *coeffs, int32_t z, int32_t v);

/**
 * Tells the estimator the velocity, lsb.v; any. Velocity context.
 * [6] |v|/v_s is Q20, and saturates at 512 or more. [7] The viscous term is within 2 of its units and
 * 2^-22 of itself. Cost: 19 products of 32 by 32 bits.
 */
void epf_q31_set_velocity(epf_q31_t *ep, int32_t v);

/**
 * Advances the state over a displacement, lsb.x; any. Returns z_k in u. Displacement context.
 * For the z_ss(v) in use within 3e-6 z_max of eqs. (12) and (13), or of the mean-value rule. [9] A longer
 * displacement may end further from z_ss(v) by 8 u. Cost: 1 product in the elastic regime, beyond it 10,
 * by the mean-value rule 21.
 */
int32_t epf_q31_advance(epf_q31_t *ep, int32_t dx);

/** set_velocity, then advance. Displacement and velocity context in one. Cost: the sum of the two. */
int32_t epf_q31_update(epf_q31_t *ep, int32_t dx, int32_t v);

/**
 * Friction force of the present state, eq. (14), in lsb.f; dt in lsb.t, 0 counts as rejected.
 * Displacement context.
 * [11] The damping term is within 4 of its units and 2^-22 of itself. [12] The sum is exact; scaled by
 * 24 bits, the result is within 0.5 lsb.f and 4e-7 of it. [14] Where lsb.f <= 0.999 sigma_0 lsb.x, Theorem 4
 * holds for the rounded force too, with sigma_0 within 2^-22. Cost: 10 products.
 */
int32_t epf_q31_force(epf_q31_t *ep, uint32_t dt);

/** update, then force, to the same bits. Displacement and velocity context in one. Cost: the sum. */
int32_t epf_q31_step(epf_q31_t *ep, int32_t dx, int32_t v, uint32_t dt);

/** The force last published, lsb.f. Any context. Cost: one load. */
int32_t epf_q31_output(const epf_q31_t *ep);

/** The state z_k in u. Any context. Cost: one load. */
int32_t epf_q31_z(const epf_q31_t *ep);

#ifdef __cplusplus
}
#endif

#endif
