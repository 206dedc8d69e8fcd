/* SPDX-License-Identifier: MIT */
/**
 * @file q15.h
 * The estimator on 16-bit integer signals, without 64-bit arithmetic: for Cortex-M0 and AVR. The state
 * keeps its 32 bits. fixed.h is the manual; here stands what is particular to this variant.
 */
#ifndef EPF_Q15_H
#define EPF_Q15_H

#include "epf/detail/constants.h"
#include "epf/fixed.h"

#ifdef __cplusplus
extern "C" {
#endif

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
    uint32_t ratio;          /**< |v| to |v|/v_s in Q10: 2^-16 min(|v|, ratio_limit) ratio */
    uint16_t ratio_limit;    /**< 60 v_s, or as much as a velocity can be */
    uint16_t leap;          /**< the smallest displacement of 2 z_max or more, counts, if it fits */
    uint32_t viscous;       /**< |v| to sigma_2 |v| in 256 sigma_0 u, likewise */
    uint16_t viscous_limit; /**< where the viscous term saturates */
    uint8_t viscous_shift;  /**< 3 to 31 */
    int8_t damping_shift; /**< weight of the leading bits of sigma_1/sigma_0, see damping_term() */
    uint16_t damping;     /**< the leading bits */
    uint16_t output;      /**< leading bits of 256 sigma_0 u in lsb.f */
    uint8_t output_shift; /**< 256 sigma_0 u is output 2^-(17 + output_shift) */
    uint8_t z_shift;      /**< 0 to 29 */
} epf_q15_coeffs_t;

/** All that follows from the velocity alone. Private. */
typedef struct {
    int32_t z_ss;          /* |z_ss(v)|, u */
    int32_t viscous;       /* sigma_2 v, 256 sigma_0 u */
    uint32_t span_inverse; /* 2^(32 + span_shift)/span, span = z_ss - z_ba */
    uint16_t span_share;   /* span/z_ss in Q16 */
    uint8_t span_shift;    /* which bits of the span are in its reciprocal */
} epf_q15_point_t;

/** One contact. Allocate it anywhere, initialise it by epf_q15_init. Only `rejected` is public. */
typedef struct {
    const epf_q15_coeffs_t *coeffs;
    int32_t z;                 /* z_k, u */
    int32_t dzeta;             /* s (z_k - z_{k-1}), u, s = sgn dx_k */
    int16_t force;             /* as last published, lsb.f */
    uint16_t rejected;         /**< unusable values (dt = 0) since init; stays at UINT16_MAX */
    int8_t direction;          /* sgn(dx_k) */
    uint8_t published;         /* index of the published operating point */
    epf_q15_point_t points[2]; /* the published one, and the one being prepared */
} epf_q15_t;

/**
 * Coefficients as a constant initialiser, equal to those of epf_q15_coeffs_init.
 *
 *     #define SLIDE   1e5f, 63.0f, 0.0f, 1.0f, 1.1f, 1e-5f, 8e-6f, \
 *                     EPF_STRIBECK_LORENTZIAN, EPF_UPDATE_MEAN_VALUE
 *     #define SIGNALS 1e-7f, 1e-7f, 1e-4f, 1e-5f   // 0.1 um, 0.1 um/s, 0.1 mN, 10 us
 *     static const epf_q15_coeffs_t slide = EPF_Q15_COEFFS(SLIDE, SIGNALS);
 *
 * In C++ declare the object constexpr, or it may be made at start-up.
 */
#define EPF_Q15_COEFFS(...) EPF_FIXED_COEFFS_(EPF_Q15_DERIVE_, EPF_Q15_LARGEST_, __VA_ARGS__)

/** Makes coefficients at run time; f_max up to 32,767 lsb.f. Start-up. */
epf_status_t epf_q15_coeffs_init(epf_q15_coeffs_t *coeffs, const epf_params_t *params,
                                 const epf_lsb_t *lsb);

/** Prepares an estimator at rest. Start-up. Cost: that of epf_q15_set_velocity. */
void epf_q15_init(epf_q15_t *ep, const epf_q15_coeffs_t *coeffs);

/** Puts the state to z, in u. Displacement context. Cost: 2 products. */
void epf_q15_reset(epf_q15_t *ep, int32_t z);

/**
 * Steady-state friction f_ss(v) in lsb.f, v in lsb.v; any. Any context.
 * [2] within 1.2e-3 (f_max - f_c) and 1.6 lsb.f. Cost: that of epf_q15_set_velocity at the most.
 */
int16_t epf_q15_fss(const epf_q15_coeffs_t *coeffs, int16_t v);

/**
 * alpha(z, v), eq. (10), in Q30: 2^30 is 1; z in u, v in lsb.v; any. Any context.
 * Within 2e-3 of eq. (10) for the z_ss(v) in use, where z_ss - z_ba is above z_max/64. Below that it gets
 * coarser, and below z_max/512 it may be anything from there up to 1. Cost: that of epf_q15_set_velocity
 * and epf_q15_advance.
 */
int32_t epf_q15_alpha(const epf_q15_coeffs_t *coeffs, int32_t z, int16_t v);

/**
 * Tells the estimator the velocity, lsb.v; any. Velocity context.
 * [6] |v|/v_s is Q10, and saturates at 60 or less, where less than 1/900 of the Stribeck effect is left.
 * [7] The viscous term is within 2 of its units and 2^-14 of itself. Cost: 18 products of 16 by 16 bits.
 */
void epf_q15_set_velocity(epf_q15_t *ep, int16_t v);

/**
 * Advances the state over a displacement, lsb.x; any. Returns z_k in u. Displacement context.
 * For the z_ss(v) in use within 1e-3 z_max of eqs. (12) and (13), or of the mean-value rule. For the exact
 * z_ss(v) the latter is within 1e-3 z_max up to f_max = 2 f_c and 2e-3 up to 10 f_c; above that z_ss(v) itself
 * is too coarse at speed.
 * [9] A longer displacement may end further from z_ss(v) by 2.5e-4 z_max. Cost: 1 product in the elastic
 * regime, beyond it 11, by the mean-value rule 23.
 */
int32_t epf_q15_advance(epf_q15_t *ep, int16_t dx);

/** set_velocity, then advance. Displacement and velocity context in one. Cost: the sum of the two. */
int32_t epf_q15_update(epf_q15_t *ep, int16_t dx, int16_t v);

/**
 * Friction force of the present state, eq. (14), in lsb.f; dt in lsb.t, 0 counts as rejected.
 * Displacement context.
 * [11] The damping term is within 4 of its units and 2^-12 of itself. [12] sigma_0 z is cut to
 * 256 sigma_0 u; the sum is then exact, and scaled by 16 bits the result is within 1.6 lsb.f of it. [14]
 * Where lsb.f <= sigma_0 lsb.x/2, Theorem 4 holds for the rounded force too, with sigma_0 within 2^-15.
 * Cost: 10 products.
 */
int16_t epf_q15_force(epf_q15_t *ep, uint16_t dt);

/** update, then force, to the same bits. Displacement and velocity context in one. Cost: the sum. */
int16_t epf_q15_step(epf_q15_t *ep, int16_t dx, int16_t v, uint16_t dt);

/** The force last published, lsb.f. Any context. Cost: one load. */
int16_t epf_q15_output(const epf_q15_t *ep);

/** The state z_k in u. Any context. Cost: one load. */
int32_t epf_q15_z(const epf_q15_t *ep);

#ifdef __cplusplus
}
#endif

#endif
