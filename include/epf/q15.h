/* SPDX-License-Identifier: MIT */
/**
 * @file q15.h
 * The estimator on 16-bit integer signals, in units that the user gives: see fixed.h for the numbers.
 * For cores with nothing but a 16 by 16 to 32-bit multiplication (Cortex-M0, AVR): no 64-bit
 * arithmetic and no division anywhere but in coeffs_init. The state has 32 bits all the same.
 *
 * Words. u is lsb.x 2^-z_shift, the unit of z; s = sgn dx, zeta = s z, d = |dx|; dw = dx - dz is the
 * plastic part of a displacement; W = sigma_0 z^2/2; case 1 is zeta > z_ss(v) before a motion.
 *
 * Promise. With valid coefficients the lemmas and Theorems 1 to 4 hold in exact integer arithmetic,
 * for every sequence of inputs, the extremes of the types included (tests/theorems, tests/proof):
 *  - |z| <= z_max, and after any motion zeta <= z_ss(v);
 *  - in the elastic regime z moves by exactly dx 2^z_shift, so there is no drift, for ever;
 *  - below z_ss every count makes progress, so steady motion reaches z_ss exactly, in finitely many
 *    steps, and stays;
 *  - before it is rounded to lsb.f the force obeys f dw > 0 and 2 f dx > 2 (W_k - W_{k-1}).
 *
 * Contexts. Three may share one estimator without locks:
 *  - the *displacement* context (an encoder interrupt, or the control loop) calls advance, update,
 *    force, step, reset, and alone changes the state;
 *  - the *velocity* context (the control loop) may call set_velocity at another priority: the
 *    operating point is prepared aside and published by one byte store, so that advance never sees
 *    half of it. Where the velocity context is the one that preempts, it must not do so twice
 *    within one advance or force;
 *  - any number of *readers* call output, which loads the one word that force stores.
 * A function that belongs to two contexts (update, step) puts both at the same priority. On a core
 * that loads 32 bits in pieces (8 and 16 bits), readers disable the interrupt around output. All
 * contexts run on one core: nothing here orders the memory of a second one.
 *
 * Cost. No division, no floating point but in coeffs_init, no heap, no static data, no unbounded loop.
 * Products, all but one in advance of 16 by 16 bits, are stated per function.
 *
 * "Scaling and overflow" paragraphs number their sentences; fixed_contract_test.c has a test of each
 * number, for this variant and for q31.
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
    int32_t z_max;           /**< f_max/sigma_0, u: no state is ever larger; 2^29 to 2^30 */
    int32_t z_c;             /**< f_c/sigma_0, u */
    int32_t z_ba;            /**< break-away deflection, u; at least one count of displacement */
    uint32_t unit;           /**< one count of displacement, u: 2^z_shift */
    uint32_t ratio;          /**< |v| to |v|/v_s in Q10: 2^-16 min(|v|, ratio_limit) ratio */
    uint16_t ratio_limit;    /**< 60 v_s, or as much as a velocity can be */
    uint16_t leap;           /**< the smallest displacement of 2 z_max or more, counts, if it fits */
    uint32_t viscous;        /**< |v| to sigma_2 |v| in 2^8 sigma_0 u, likewise */
    uint16_t viscous_limit;  /**< where the viscous term saturates */
    uint8_t viscous_shift;   /**< 3 to 31 */
    int8_t damping_shift;    /**< weight of the leading bits of sigma_1/sigma_0, see damping_term() */
    uint16_t damping;        /**< the leading bits */
    uint16_t output;         /**< leading bits of 2^8 sigma_0 u in lsb.f */
    uint8_t output_shift;    /**< 2^8 sigma_0 u is output 2^-(17 + output_shift) */
    uint8_t z_shift;         /**< 0 to 29 */
    epf_stribeck_t stribeck; /**< form of f_ss(v) */
} epf_q15_coeffs_t;

/** All that follows from the velocity alone. Private. */
typedef struct {
    int32_t z_ss;          /* |z_ss(v)|, u */
    int32_t viscous;       /* sigma_2 v, 2^8 sigma_0 u */
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
 * Coefficients as a constant initialiser, equal to those of epf_q15_coeffs_init: they go to flash, no
 * floating-point routine is linked, and bad parameters fail to compile. Takes the fields of
 * epf_params_t, then those of epf_lsb_t, in their order:
 *
 *     #define SLIDE   1e5f, 63.0f, 0.0f, 1.0f, 1.1f, 1e-5f, 8e-6f, \
 *                     EPF_STRIBECK_LORENTZIAN, EPF_UPDATE_SATURATED
 *     #define SIGNALS 1e-7f, 1e-7f, 1e-4f, 1e-5f   // 0.1 um, 0.1 um/s, 0.1 mN, 10 us
 *     static const epf_q15_coeffs_t slide = EPF_Q15_COEFFS(SLIDE, SIGNALS);
 *
 * The object must have static storage duration, or bad parameters are not refused but divide by
 * zero. In C++ declare it constexpr, for the same reason.
 */
#define EPF_Q15_COEFFS(...) EPF_FIXED_COEFFS_(EPF_Q15_DERIVE_, EPF_Q15_LARGEST_, __VA_ARGS__)

/**
 * Makes coefficients at run time.
 *
 * @param coeffs  receives them; untouched unless EPF_OK is returned.
 * @param params  in SI units.
 * @param lsb     what one LSB of each signal weighs, in SI units.
 * @return EPF_OK, or the first cause found: EPF_ERR_NULL for a null pointer, what epf_params_check
 *         says, then
 *         - EPF_ERR_LSB_X: lsb.x is not positive, or so coarse that z_ba is below one count or not
 *           to be told from z_c, or so fine that z_max is beyond 2^30 counts;
 *         - EPF_ERR_LSB_V: lsb.v is not positive, or v_s is not within 2^-24 to 2^33 of it, or the
 *           viscous force of one lsb.v is beyond the elastic force of 2^24 lsb.x;
 *         - EPF_ERR_LSB_F: lsb.f is not positive, or f_max is not within 1 to 32767 of it;
 *         - EPF_ERR_LSB_T: lsb.t is not positive, or sigma_1/sigma_0 is beyond 2^24 of it.
 *
 * Context: start-up. Cost: floating point, some 20 divisions, 5 loops of up to 56 doublings.
 */
epf_status_t epf_q15_coeffs_init(epf_q15_coeffs_t *coeffs, const epf_params_t *params,
                                 const epf_lsb_t *lsb);

/**
 * Prepares an estimator at rest: z = 0, v = 0, force 0, nothing rejected.
 *
 * @param ep      estimator, not null.
 * @param coeffs  valid coefficients, not null, which must outlive the estimator.
 *
 * Context: start-up, before any other call. Cost: that of epf_q15_set_velocity.
 */
void epf_q15_init(epf_q15_t *ep, const epf_q15_coeffs_t *coeffs);

/**
 * Puts the state to z, as after homing, and publishes the force sigma_0 z of a contact at rest.
 * Velocity and the count of rejected values stay.
 *
 * @param ep  estimator.
 * @param z   deflection, u = lsb.x 2^-z_shift; any.
 *
 * Scaling and overflow: [1] z is clamped to [-z_max, z_max].
 * Context: displacement. Cost: 2 products.
 */
void epf_q15_reset(epf_q15_t *ep, int32_t z);

/**
 * Steady-state friction f_ss(v), eqs. (6), (7), (8), without the viscous term.
 *
 * @param coeffs  valid coefficients.
 * @param v       velocity, lsb.v; any.
 * @return force in lsb.f, with the sign of v; 0 for v = 0 (sgn 0 = 0).
 *
 * Scaling and overflow: [2] the result is within 1e-3 (f_max - f_c) and 1.6 lsb.f. [3] But for 1.6 lsb.f
 * it is from f_c to f_max, so it cannot overflow.
 * Context: any; reentrant. Cost: that of epf_q15_set_velocity at the most.
 */
int16_t epf_q15_fss(const epf_q15_coeffs_t *coeffs, int16_t v);

/**
 * Share of a displacement that is plastic, alpha(z, v), eq. (10): 0 up to z_ba, 1 from z_ss(v) on, a
 * half period of a sine between, within 2e-3.
 *
 * @param coeffs  valid coefficients.
 * @param z       deflection, u; any.
 * @param v       velocity, lsb.v; any. Only sgn(v) and z_ss(v) count.
 * @return alpha; 0 where z and v differ in sign, and where one of them is 0.
 *
 * Scaling and overflow: [4] the result is Q30, from 0 to 2^30, which is 1, in steps of 2^14.
 * Context: any; reentrant. Cost: that of epf_q15_set_velocity and epf_q15_advance.
 */
int32_t epf_q15_alpha(const epf_q15_coeffs_t *coeffs, int32_t z, int16_t v);

/**
 * Tells the estimator the velocity: computes |z_ss(v)|, eq. (9), what the update needs to do without
 * divisions, and the viscous term.
 *
 * @param ep  estimator.
 * @param v   velocity, lsb.v; any. Its sign is used by the force, and only while dx = 0.
 *
 * Scaling and overflow: [5] all of the range of v is allowed, the most negative number included. [6]
 * |v|/v_s is Q10 and saturates at 60, where less than 1/3600 of the Stribeck effect is left. [7] The viscous term
 * is rounded towards zero to 2^8 sigma_0 u and saturates at 2^29 of that, 128 f_max at the least.
 * Context: velocity. Cost: 22 products and 4 normalisations at the most.
 */
void epf_q15_set_velocity(epf_q15_t *ep, int16_t v);

/**
 * Advances the state over one displacement, eqs. (12) and (13), at the velocity last set. The
 * direction is that of dx alone. dx = 0 changes no state: the model knows no time.
 *
 * @param ep  estimator.
 * @param dx  displacement since the last call, lsb.x; any.
 * @return z_k in u = lsb.x 2^-z_shift.
 *
 * Scaling and overflow: [8] dx enters the state as dx 2^z_shift u, exactly. [9] All of the range of
 * dx is allowed, the most negative number included; from 2 z_max on the state ends in z_ss(v). [10]
 * The result is within [-z_max, z_max], so that nothing wraps.
 * Context: displacement. Cost: a product and a sum in the elastic regime, beyond it 10 products more.
 */
int32_t epf_q15_advance(epf_q15_t *ep, int16_t dx);

/**
 * set_velocity, then advance: one step of Algorithm 1 without the force.
 *
 * @param ep  estimator.
 * @param dx  displacement, lsb.x, as for epf_q15_advance.
 * @param v   velocity, lsb.v, as for epf_q15_set_velocity.
 * @return z_k in u.
 *
 * Scaling and overflow: as for the two.
 * Context: displacement and velocity in one. Cost: the sum of the two.
 */
int32_t epf_q15_update(epf_q15_t *ep, int16_t dx, int16_t v);

/**
 * Friction force of the present state, eq. (14):
 *
 *     f = sigma_0 z_k + sigma_1 (z_k - z_{k-1})/dt + sigma_2 v',   v' = |v| sgn(dx), or v if dx = 0
 *
 * It opposes motion towards +x where positive, so a compensator adds it to its command. Where the
 * deflection is giving way to the motion (case 1) the damping term is limited to 1 - 2^-10 of the
 * other two (the passivity guard), so that Theorems 3 and 4 hold for every sigma_1 and dt.
 *
 * @param ep  estimator.
 * @param dt  time over which the last displacement took place, lsb.t. 0 counts as rejected, and the
 *            damping term is 0.
 * @return force in lsb.f.
 *
 * Scaling and overflow: [11] sigma_0 z is exact; the damping term is within 2^-13 of itself and one unit
 * of 2^8 sigma_0 u, and saturates at 2^29 of that. [12] The sum is exact; cut to
 * 2^8 sigma_0 u and scaled by 16 bits, the result is within 1.6 lsb.f of it. [13] It saturates at the
 * largest number and its negative. [14] Rounding never turns the sign of the force; where
 * lsb.f <= sigma_0 lsb.x/2, Theorem 4 holds for the rounded force too, with sigma_0 within 2^-15.
 * Publishes the force for epf_q15_output by one store of an aligned word.
 * Context: displacement. Cost: 9 products and 2 normalisations.
 */
int16_t epf_q15_force(epf_q15_t *ep, uint16_t dt);

/**
 * update, then force: all of Algorithm 1.
 *
 * @param ep  estimator.
 * @param dx  displacement, lsb.x, as for epf_q15_advance.
 * @param v   velocity, lsb.v, as for epf_q15_set_velocity.
 * @param dt  time, lsb.t, as for epf_q15_force.
 * @return force in lsb.f.
 *
 * Scaling and overflow: as for the three.
 * Context: displacement and velocity in one. Cost: the sum of the three.
 */
int16_t epf_q15_step(epf_q15_t *ep, int16_t dx, int16_t v, uint16_t dt);

/**
 * The force last published by epf_q15_force, lsb.f (by init: 0; by reset: sigma_0 z).
 *
 * Context: any, also one that the displacement context interrupts: one load of an aligned word
 * (except on 8 and 16 bit cores: see above). Cost: that load.
 */
int16_t epf_q15_output(const epf_q15_t *ep);

/**
 * The state z_k, in u = lsb.x 2^-z_shift.
 *
 * Context: as epf_q15_output. Cost: one load.
 */
int32_t epf_q15_z(const epf_q15_t *ep);

#ifdef __cplusplus
}
#endif

#endif
