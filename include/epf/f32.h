/* SPDX-License-Identifier: MIT */
/**
 * @file f32.h
 * The estimator in single precision: displacement in m, velocity in m/s, time in s, force in N.
 *
 *     epf_f32_t contact;
 *     epf_f32_init(&contact, &coeffs);                start-up; coeffs: EPF_F32_COEFFS or epf_f32_coeffs_init
 *     force = epf_f32_step(&contact, dx, v, dt);      where displacement and velocity come together
 *
 *     epf_f32_set_velocity(&contact, v);              or split: the control loop, which divides ...
 *     epf_f32_advance(&contact, dx);                  ... and the encoder interrupt, which does not
 *     force = epf_f32_force(&contact, dt);
 *
 * Promises. With valid coefficients, and whatever the inputs are:
 *  - |z| <= z_max, and after any motion |z| <= max(|z before|, z_ss(v));
 *  - the force is finite;
 *  - a displacement of 2 z_max or more, infinity included, ends exactly in z_ss(v), by either update rule;
 *    up to there a longer one never ends further from z_ss(v) than a shorter one, by the mean-value rule to
 *    1e-6 z_max;
 *  - NaN is ignored, and counted in `rejected`; one good sample after it is a good sample. A jump of
 *    dx is valid input: it saturates the state, which the next motion or a reset then corrects;
 *  - step returns and leaves, bit for bit, what set_velocity, advance and force would.
 *
 * State. z is kept as an unevaluated sum of two floats, so that displacements far below the last
 * digit of z add up instead of vanishing, and what goes in comes out again. In the elastic regime the
 * sum of displacements is exact where each of them is 0 or at least 2^-23 z_max and z itself is a multiple
 * of 2^-46 z_max; else each displacement is rounded by 2^-48 z_max at the most, and these roundings can add
 * up. A motion that ends within one rounding of z_ss ends in z_ss. One step is within 1e-6 z_max of the
 * same step in double precision, by the mean-value rule within 2e-6 z_max.
 *
 * Contexts. Three may share one estimator without locks, on one core:
 *  - the *displacement* context (an encoder interrupt, or the control loop) calls advance, update,
 *    force, step and reset, and alone changes the state;
 *  - the *velocity* context (the control loop) may call set_velocity at another priority: the
 *    operating point is prepared aside and published by one byte store, so that advance never sees
 *    half of it. There are two operating points: a velocity context that interrupts may do so at
 *    most once within one advance or force;
 *  - any number of *readers* call output, z, or read `rejected`: one load of an aligned word each.
 * A function that belongs to two contexts (update, step) puts both at the same priority. On a core
 * that loads a word in pieces (8 and 16 bits), the readers mask the interrupt meanwhile.
 *
 * `rejected` counts in both contexts, by a load, an addition and a store. If one context interrupts the
 * other between these, what it has counted is lost; on 8 and 16 bit cores, where the count is loaded in
 * pieces, it can also come out too high, by up to 2^24. Bad input that is rare is counted well all the
 * same; where the count itself must be exact, call set_velocity with the interrupt masked.
 *
 * Arithmetic. IEEE single precision, rounded to nearest. f32.c refuses -ffast-math where the compiler
 * says so, and switches reassociation off where clang is silent; the promises then hold, but the bits are
 * not those of other builds. Old compilers (avr-gcc 5) are silent about parts of -ffast-math, such as
 * -fassociative-math: do not use them there. Where subnormal numbers are flushed to zero (some FPUs at
 * start-up, -ffast-math at link time) the promises hold for z_max above 1e-18 m. There a dx below FLT_MIN
 * still has a direction, so that by the saturated rule it lets go in case 1, but moves z by nothing; v
 * below FLT_MIN counts as 0, and dt below it is unusable.
 *
 * Cost. No loop, no recursion, no call of memset or libm, no heap, no static data. Divisions are stated
 * per function; the rest is multiplications, additions and comparisons of floats.
 */
#ifndef EPF_F32_H
#define EPF_F32_H

#include "epf/detail/constants.h"
#include "epf/params.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * What the estimator needs of the parameters, made once. Constant from then on: it may live in
 * flash and be shared by any number of estimators. Read it freely, change it never.
 */
typedef struct {
    float sigma_0;           /**< N/m */
    float sigma_1;           /**< N s/m */
    float sigma_2;           /**< N s/m */
    float f_c;               /**< N */
    float f_max;             /**< N */
    float inv_v_s;           /**< 1/v_s, s/m */
    float z_ba;              /**< m */
    float z_c;               /**< f_c/sigma_0, m */
    float z_excess;          /**< z_max - z_c, m */
    float z_max;             /**< f_max/sigma_0, m, rounded to z_c + z_excess: the largest state */
    epf_stribeck_t stribeck; /**< form of f_ss(v) */
    epf_update_t update;     /**< update rule */
} epf_f32_coeffs_t;

/** All that follows from the velocity alone. Private. */
typedef struct {
    float v;        /* m/s */
    float z_ss;     /* |z_ss(v)|, eq. (9), m */
    float inv_z_ss; /* 1/z_ss */
    float inv_span; /* 1/(z_ss - z_ba) */
} epf_f32_point_t;

/** One contact. Allocate it anywhere, initialise it by epf_f32_init. Only `rejected` is public. */
typedef struct {
    epf_f32_point_t points[2]; /* the published operating point, and the one being prepared */
    const epf_f32_coeffs_t *coeffs;
    float z;           /* z_k, m, to float precision */
    float z_low;       /* what z_k has beyond that */
    float dz;          /* z_k - z_{k-1}, m */
    float force;       /* as last published, N */
    uint32_t rejected; /**< unusable input values seen since init; stays at UINT32_MAX */
    int8_t direction;  /* sgn dx_k; 0 after init and reset */
    uint8_t published; /* index of the published operating point */
} epf_f32_t;

/**
 * Makes coefficients at run time.
 *
 * @param coeffs  receives them; untouched unless EPF_OK is returned.
 * @param params  in SI units.
 * @return EPF_OK, EPF_ERR_NULL for a null pointer, or what epf_params_check says.
 *
 * Context: start-up. Cost: epf_params_check, and 3 divisions.
 */
epf_status_t epf_f32_coeffs_init(epf_f32_coeffs_t *coeffs, const epf_params_t *params);

/**
 * The same coefficients, bit for bit, as a constant initialiser: they go to flash, and bad
 * parameters fail to compile. Takes the fields of epf_params_t in their order, so that one list can
 * serve both:
 *
 *     #define SLIDE 1e5f, 63.0f, 0.0f, 1.0f, 1.1f, 1e-5f, 8e-6f, \
 *                   EPF_STRIBECK_LORENTZIAN, EPF_UPDATE_MEAN_VALUE
 *     static const epf_f32_coeffs_t slide = EPF_F32_COEFFS(SLIDE);
 *     static const epf_params_t slide_params = {SLIDE};
 *
 * Parameters are literals or macros, not variables. gcc and clang refuse bad ones in every object, and
 * the first error names the cause; other C compilers refuse them in objects of static storage duration.
 * In C++ declare the object constexpr, or it may be made at start-up.
 */
#define EPF_F32_COEFFS(...) EPF_F32_COEFFS_(__VA_ARGS__)

/**
 * Prepares an estimator at rest: z = 0, v = 0, force 0, nothing rejected.
 *
 * @param ep      estimator, not null.
 * @param coeffs  valid coefficients, not null, which must outlive the estimator.
 *
 * Context: start-up, before any other call. Cost: epf_f32_set_velocity, and eight stores.
 */
void epf_f32_init(epf_f32_t *ep, const epf_f32_coeffs_t *coeffs);

/**
 * Puts the state to z, as after homing, and publishes the force sigma_0 z of a contact at rest.
 * The velocity and the count of rejected values stay. The last displacement is forgotten: until the
 * next one force has no damping term, and the viscous term has the sign of v.
 *
 * @param ep  estimator.
 * @param z   deflection, m; clamped to [-z_max, z_max]; NaN sets z = 0, and is counted.
 *
 * Context: displacement. Cost: no division.
 */
void epf_f32_reset(epf_f32_t *ep, float z);

/**
 * Steady-state friction f_ss(v), eqs. (6), (7), (8), without the viscous term.
 *
 * @param coeffs  valid coefficients.
 * @param v       velocity, m/s; infinity is the high-speed limit.
 * @return force in N, f_c <= |f_ss| <= f_max with the sign of v; 0 for v = 0 (sgn 0 = 0) and NaN.
 *         The exponential of (7) is within 3e-7 of the exact one.
 *
 * Context: any; reentrant. Cost: 1 division with (8), none with (6) and (7).
 */
float epf_f32_fss(const epf_f32_coeffs_t *coeffs, float v);

/**
 * Share of a displacement that is plastic, alpha(z, v), eq. (10): 0 up to z_ba, 1 from z_ss(v) on,
 * a half period of a sine between.
 *
 * @param coeffs  valid coefficients.
 * @param z       deflection, m; any.
 * @param v       velocity, m/s; any. Only sgn(v) and z_ss(v) count.
 * @return alpha in [0, 1], within 1e-6 of the exact value for the z_ss(v) in use; 0 where z and v
 *         differ in sign, and where one of them is 0 or NaN.
 *
 * Context: any; reentrant. Cost: up to 2 divisions.
 */
float epf_f32_alpha(const epf_f32_coeffs_t *coeffs, float z, float v);

/**
 * Tells the estimator the velocity: computes |z_ss(v)|, eq. (9), and its reciprocals.
 *
 * @param ep  estimator.
 * @param v   velocity, m/s. Its sign is used by the force, and only while dx = 0. Where it is infinite
 *            z_ss is that of the high-speed limit, and the viscous term, if there is one, saturates.
 *            NaN is counted, and the last velocity stays.
 *
 * Context: velocity. Cost: 2 divisions with eq. (8), 1 with (6) and (7); 1 more for parameters with
 * which z_ss (z_ss - z_ba) is not between FLT_MIN and 2^126 m^2.
 */
void epf_f32_set_velocity(epf_f32_t *ep, float v);

/**
 * Advances the state over one displacement, eqs. (12) and (13), at the velocity last set. The
 * direction is that of dx alone. dx = 0 changes no state: the model knows no time.
 *
 * @param ep  estimator.
 * @param dx  displacement since the last call, m; from 2 z_max on, and for infinity, the state ends
 *            in z_ss(v). NaN is counted and changes nothing else.
 * @return z_k in m, |z_k| <= z_max.
 *
 * Context: displacement. Cost: no division; least in the elastic regime.
 */
float epf_f32_advance(epf_f32_t *ep, float dx);

/**
 * set_velocity, then advance: one step without the force.
 *
 * @param ep  estimator.
 * @param dx  displacement, m, as for epf_f32_advance.
 * @param v   velocity, m/s, as for epf_f32_set_velocity.
 * @return z_k in m.
 *
 * Context: displacement and velocity in one. Cost: the sum of the two.
 */
float epf_f32_update(epf_f32_t *ep, float dx, float v);

/**
 * Friction force of the present state, eq. (14):
 *
 *     f = sigma_0 z_k + sigma_1 (z_k - z_{k-1})/dt + sigma_2 v',   v' = |v| sgn(dx), or v if dx = 0
 *
 * It opposes motion towards +x where positive, so a compensator adds it to its command.
 *
 * The passivity guard: where the deflection gives way to the motion (case 1: z_ss(v) fell below the
 * deflection along the motion) the damping term opposes the other two, and is limited to 1 - 2^-10 of them. Theorems 3 and 4 then
 * hold for every sigma_1 and dt, up to the rounding of z: a plastic displacement below 2^-23 z_max may
 * have either sign, and f dx may fall short of W_k - W_{k-1} where |dx| is below 2^-22 z_max. They need
 * sigma_0 z_ba and f_c/1024 to be normal numbers. The guard
 * changes nothing while sigma_1 is below 0.998 of bound (22) (epf_sigma_1_limit) and
 * f_max >= 1.001 f_c. For f_max nearer to f_c the roundings of z, 2^-24 z_max each, are no longer small
 * beside z_max - z_c: the guard may then act below the bound.
 *
 * The velocity is that last set when force is called. Called once more, it gives the force of the last
 * displacement once more, the damping term included.
 *
 * @param ep  estimator.
 * @param dt  time over which the last displacement took place, s. Unless it is positive and finite
 *            it is counted, and the damping term is 0.
 * @return force in N, always finite. Where dt is unusable, or a term or |f| + dt leaves the range of float,
 *         the damping and the viscous term are limited to FLT_MAX/4 each; near overflow the returned
 *         force is therefore smaller.
 *         sigma_1 dz may overflow as long as sigma_1 dz/dt does not; where it is below FLT_MIN the
 *         damping term loses digits.
 *
 * Publishes the force for epf_f32_output by one store of an aligned word.
 * Context: displacement. Cost: 1 division; 2 where sigma_1 dz overflows.
 */
float epf_f32_force(epf_f32_t *ep, float dt);

/**
 * update, then force, with the same bits. By the saturated rule that is all of Algorithm 1, and one pass,
 * for less than the calls; by the mean-value rule it is the three calls.
 *
 * @param ep  estimator.
 * @param dx  displacement, m, as for epf_f32_advance.
 * @param v   velocity, m/s, as for epf_f32_set_velocity.
 * @param dt  time, s, as for epf_f32_force.
 * @return force in N.
 *
 * Context: displacement and velocity in one. Cost: the sum of the two.
 */
float epf_f32_step(epf_f32_t *ep, float dx, float v, float dt);

/**
 * The force last published by epf_f32_force, N (by init: 0; by reset: sigma_0 z).
 *
 * Context: any, also one that the displacement context interrupts: one load of an aligned word
 * (except on 8 and 16 bit cores: see above). Cost: that load.
 */
float epf_f32_output(const epf_f32_t *ep);

/**
 * The state z_k, m.
 *
 * Context: as epf_f32_output. Cost: one load.
 */
float epf_f32_z(const epf_f32_t *ep);

#ifdef __cplusplus
}
#endif

#endif
