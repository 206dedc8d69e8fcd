/* SPDX-License-Identifier: MIT */
/**
 * @file fixed.h
 * The manual of the two fixed-point variants, epf_q31_... and epf_q15_...: what is the same for both.
 * Include q31.h or q15.h; they have the same functions and say where the variant differs. A contact of
 * one is not a contact of the other: the types are distinct. C++ refuses to mix them; C warns, and with
 * -Werror=incompatible-pointer-types refuses. The coefficients of one variant made by the macro of the
 * other are refused by C++ only.
 *
 * Signals. Plain integers in units that the user gives as an epf_lsb_t: encoder counts, counts per
 * second, timer ticks, DAC or PWM or millinewton units. Nothing is scaled by the user.
 *
 *     signal         unit                            held as
 *     dx, v, f, dt   lsb.x, lsb.v, lsb.f, lsb.t      int32_t or int16_t, dt unsigned
 *     z              u = lsb.x 2^-z_shift            int32_t, |z| <= z_max < 2^30
 *     force inside   sigma_0 u                       z + 256 (damping + viscous), all integers, so that
 *                                                    sigma_0 z is exact
 *
 * z_shift is the largest that keeps z_max within 2^30 u. A displacement thus enters the state by a
 * shift, exactly, and in the elastic regime it leaves it exactly: there is no drift, for ever. In SI
 * units z is z lsb.x 2^-z_shift metres.
 *
 * Choosing the weights. lsb.x is what the encoder gives. lsb.v well below v_s, v_s/100 say: a speed
 * that rounds to 0 counts as rest, where z_ss = f_max/sigma_0. For q15, lsb.f of f_max/16000 leaves
 * room for the damping and viscous terms, and lsb.x of z_max/16000 or coarser lets every displacement
 * short of 2 z_max fit 16 bits. Clamp dx, v and dt before the call; never let them wrap. Ratios of
 * parameters and weights (sigma_1/sigma_0, sigma_2/sigma_0, lsb.v/lsb.x, ...) are made in single precision:
 * one above FLT_MAX is refused as if the weight were wrong, and below FLT_MIN cores differ in what they
 * make of it.
 *
 * Words. s = sgn dx, zeta = s z, d = |dx|; dw = dx - dz is the plastic part of a displacement;
 * W = sigma_0 z^2/2; case 1 is zeta > z_ss(v) before a motion.
 *
 * Promise. With valid coefficients the lemmas and Theorems 1 to 4 hold in exact integer arithmetic,
 * for every sequence of inputs, the extremes of the types included (tests/theorems, tests/proof):
 *  - |z| <= z_max, and after any motion zeta <= z_ss(v) by the saturated rule, zeta <= max(zeta before,
 *    z_ss(v)) by the mean-value rule;
 *  - in the elastic regime z moves by exactly dx 2^z_shift;
 *  - every count makes progress towards z_ss, from below and from above, if only by one u, so steady motion
 *    reaches z_ss exactly, in finitely many steps, and stays;
 *  - before it is rounded to lsb.f the force obeys f dw > 0 and 2 f dx > 2 (W_k - W_{k-1}).
 *
 * Contexts. Three may share one estimator without locks:
 *  - the *displacement* context (an encoder interrupt, or the control loop) calls advance, update,
 *    force, step, reset, and alone changes the state;
 *  - the *velocity* context (the control loop) may call set_velocity at another priority: the
 *    operating point is prepared aside and published by one byte store, so that advance never sees
 *    half of it. It may interrupt one advance or force at most once: there are two operating points, and
 *    a second set_velocity would write over the one in use;
 *  - any number of *readers* call output and z, each of which loads one aligned word.
 * A function that belongs to two contexts (update, step) puts both at the same priority. On a core
 * that loads a word in pieces (8 and 16 bits), readers disable the interrupt around the call; the other
 * functions need no guard. All contexts run on one core: nothing here orders the memory of a second one.
 *
 * Cost. No division, no floating point but in coeffs_init, no heap, no static data, no loop but in
 * coeffs_init. Cycles per core: README.md and tests/bench.
 *
 * The functions, epf_q31_ or epf_q15_ before each. Sentences of "Scaling and overflow" are numbered;
 * fixed_contract_test.c has a test of each number, for both variants.
 *
 * **coeffs_init(coeffs, params, lsb)** makes coefficients at run time, at start-up. They are untouched
 * unless EPF_OK is returned; else the first cause found: EPF_ERR_NULL for a null pointer, what
 * epf_params_check says, then
 *  - EPF_ERR_LSB_X: lsb.x is not positive, or so coarse that z_ba is below one count or not to be told
 *    from z_c, or so fine that z_max is beyond 2^30 counts;
 *  - EPF_ERR_LSB_V: lsb.v is not positive, or v_s is not above 2^-24 of it and at most 2^33 of it, or the
 *    viscous force of one lsb.v is not below the elastic force of 2^24 lsb.x;
 *  - EPF_ERR_LSB_F: lsb.f is not positive, or f_max is not from 1 to the variant's largest force in it;
 *  - EPF_ERR_LSB_T: lsb.t is not positive, or sigma_1/sigma_0 is not below 2^24 of it.
 * Floating point, some 30 divisions, loops of up to 64 doublings.
 *
 * **EPF_Q31_COEFFS(...), EPF_Q15_COEFFS(...)** make the same coefficients as a constant initialiser:
 * they go to flash, no floating-point routine is linked, and bad parameters do not compile; the first
 * error names the cause. They take the fields of epf_params_t, then those of epf_lsb_t, in their order,
 * and need a compiler that defines __GNUC__: gcc, clang and those that are like them.
 *
 * **init(ep, coeffs)** prepares an estimator at rest: z = 0, v = 0, force 0, nothing rejected. The
 * coefficients must outlive it. Start-up, before any other call.
 *
 * **reset(ep, z)** puts the state to z, as after homing, and publishes the force sigma_0 z of a contact at
 * rest. No motion is left: until the next displacement the damping term is 0, and the viscous term has
 * the sign of the velocity, which stays, as does the count of rejected values. Displacement context.
 * Scaling and overflow: [1] z is clamped to [-z_max, z_max].
 *
 * **fss(coeffs, v)** is the steady-state friction f_ss(v) in lsb.f, eqs. (6), (7), (8), without the viscous
 * term, with the sign of v; 0 for v = 0 (sgn 0 = 0). Any context; reentrant.
 * Scaling and overflow: [2] its accuracy stands at the variant. [3] But for that it is from f_c to f_max,
 * so it cannot overflow.
 *
 * **alpha(coeffs, z, v)** is the share of a displacement that is plastic, alpha(z, v), eq. (10): 0 up to
 * z_ba, 1 from z_ss(v) on, a half period of a sine between; 0 where z and v differ in sign, and where
 * one of them is 0. Any z and v; any context; reentrant.
 * Scaling and overflow: [4] the result is Q30, from 0 to 2^30, which is 1.
 *
 * **set_velocity(ep, v)** tells the estimator the velocity: it computes |z_ss(v)|, eq. (9), what the
 * update needs so that it need not divide, and the viscous term. The sign of v is used by the force only,
 * and only while dx = 0. Velocity context.
 * Scaling and overflow: [5] all of the range of v is allowed, the most negative number included. [6] |v|/v_s
 * saturates where the Stribeck effect has vanished, at the variant's limit. [7] The viscous term is
 * rounded towards zero to 256 sigma_0 u, and saturates at 32 f_max or more.
 *
 * **advance(ep, dx)** advances the state over one displacement, eqs. (12) and (13), by the update rule of
 * the coefficients and at the velocity last set, and returns z_k in u. In case 1 the saturated rule goes to
 * z_ss(v) at once, the mean-value rule towards it. The direction is that of dx alone. dx = 0 leaves z, for
 * the model knows no time; the next force then has no damping term, and v' = v. Displacement context.
 * Scaling and overflow: [8] dx enters the state as dx 2^z_shift u, exactly. [9] All of the range of dx is
 * allowed, the most negative number included; from 2 z_max on the state ends in z_ss(v), by either rule. Up
 * to there a longer displacement never ends further from z_ss(v) than a shorter one: by the saturated rule
 * exactly, by the mean-value rule to the variant's rounding. [10] The result is within [-z_max, z_max], so
 * that nothing wraps.
 *
 * **update(ep, dx, v)** is set_velocity, then advance: a step without the force.
 *
 * **force(ep, dt)** is the friction force of the present state in lsb.f, eq. (14):
 *
 *     f = sigma_0 z_k + sigma_1 (z_k - z_{k-1})/dt + sigma_2 v',   v' = |v| sgn(dx), or v if dx = 0
 *
 * It opposes motion towards +x where positive, so a compensator adds it to its command. Where the
 * deflection is giving way to the motion (case 1) the damping term is limited to 1 - 2^-10 of the
 * other two (the passivity guard), so that Theorems 3 and 4 hold for every sigma_1 and dt. dt is the time
 * over which the last displacement took place; 0 counts as rejected, and the damping term is 0.
 * Displacement context; it publishes the force for output by one store of an aligned word.
 * Scaling and overflow: [11] the damping term is rounded towards zero, to 256 sigma_0 u, and saturates at
 * 128 f_max or more; its accuracy stands at the variant. [12] The accuracy of the result stands there, too.
 * [13] The result saturates at the largest number and its negative. [14] Rounding never turns its sign.
 *
 * **step(ep, dx, v, dt)** is update, then force: the same bits, for less.
 *
 * **output(ep)** is the force last published, lsb.f (by init: 0; by reset: sigma_0 z). Any context.
 *
 * **z(ep)** is the state z_k in u. Any context.
 */
#ifndef EPF_FIXED_H
#define EPF_FIXED_H

#include "epf/params.h"

#include <stdint.h>

#endif
