/* SPDX-License-Identifier: MIT */
/*
 * The integer kernels that q31.c and q15.c share: the state, the guard, the public state machine
 * around them. No 64-bit arithmetic and no division: q15 is for cores that have neither.
 *
 * Comments that begin with an at sign are contracts in ACSL. Frama-C proves them on this text, see
 * tests/proof. They speak of the direction-normalised quantities: with s = sgn dx, zeta = s z_{k-1},
 * zeta' = s z_k, d = |dx| > 0, Z = |z_ss|, dw = d - (zeta' - zeta).
 */
#ifndef EPF_KERNEL_H
#define EPF_KERNEL_H

#include "epf/fixed.h"

#include "stribeck.h"

/* No state reaches this: the difference of two states fits 32 bits */
#define STATE_LIMIT 1073741824

/* No single term of the force beyond sigma_0 z is larger, in units of 2^8 sigma_0 u: 128 f_max at
   the least. The sum of two fits 32 bits with room. */
#define TERM_MAX 536870912u

/* ---- what the contracts speak of ----------------------------------------------------------- */

/*@ // Coefficients as epf_fixed_coeffs_init makes them
    predicate valid_coeffs(epf_fixed_coeffs_t *c) =
      \valid_read(c) &&
      0 < c->z_ba < c->z_c <= c->z_max < STATE_LIMIT &&
      0 < c->unit && 0 < c->leap && (c->leap - 1) * c->unit < 2 * c->z_max <= c->leap * c->unit &&
      c->v_s_inverse.mantissa < 16777216 && c->viscous.mantissa < 16777216 &&
      c->damping.mantissa < 16777216 && c->output.mantissa < 16777216 &&
      1 <= c->output.shift <= 64;

    // An operating point of some velocity
    predicate valid_point(epf_fixed_coeffs_t *c, epf_fixed_point_t *p) =
      c->z_c <= p->z_ss <= c->z_max &&
      -TERM_MAX <= p->viscous <= TERM_MAX &&
      p->span_zeros <= 31;

    // z_k, z_k - z_{k-1} and sgn dx_k, as a step leaves them. Where the deflection shrinks along the
    // motion it was above z_ss, and is z_ss > 0 now.
    predicate valid_motion(epf_fixed_t *ep) =
      -ep->coeffs->z_max <= ep->z <= ep->coeffs->z_max &&
      -2 * ep->coeffs->z_max <= ep->dz <= 2 * ep->coeffs->z_max &&
      -1 <= ep->direction <= 1 &&
      (ep->direction > 0 && ep->dz < 0 ==> ep->z > 0) &&
      (ep->direction < 0 && ep->dz > 0 ==> ep->z < 0);

    // A contact, also before it has its first operating point
    predicate valid_body(epf_fixed_t *ep) =
      \valid(ep) && valid_coeffs(ep->coeffs) && \separated(ep, ep->coeffs) &&
      valid_motion(ep) && ep->published <= 1;

    // A contact from epf_*_init on
    predicate valid_contact(epf_fixed_t *ep) =
      valid_body(ep) && valid_point(ep->coeffs, &ep->points[ep->published]);
*/

/* What the short path does not need, it should not save registers for */
#ifdef __GNUC__
#define OUT_OF_LINE __attribute__((noinline))
#else
#define OUT_OF_LINE
#endif

/* ---- numbers ------------------------------------------------------------------------------- */

/* |x|, also of the most negative number */
/*@ assigns \nothing;
    ensures x >= 0 ==> \result == x;
    ensures x < 0 ==> \result == -x;
*/
static inline uint32_t magnitude(int32_t x)
{
    return x < 0 ? (uint32_t)(-(x + 1)) + 1u : (uint32_t)x;
}

/* x as seen in the direction of s; s is any number that has its sign */
/*@ requires -2147483647 <= x;
    assigns \nothing;
    ensures s >= 0 ==> \result == x;
    ensures s < 0 ==> \result == -x;
*/
static inline int32_t along(int32_t s, int32_t x)
{
    return s < 0 ? -x : x;
}

/* A positive number moved up so that its highest bit is the 32nd: x 2^zeros */
typedef struct {
    uint32_t mantissa;
    int zeros;
} normal_t;

/*@ requires 0 < x;
    assigns \nothing;
    ensures 0 <= \result.zeros <= 31 && 2147483648 <= \result.mantissa;
    ensures (x < 2147483648 ==> 1 <= \result.zeros) && (x < 65536 ==> 16 <= \result.zeros);
    ensures 1048576 <= x ==> \result.zeros <= 11;
*/
static inline normal_t normalised(uint32_t x)
{
#ifdef __ARM_FEATURE_CLZ /* one instruction; a test compares the two on the cores that have it */
    const int leading = __builtin_clz(x);
    return (normal_t){x << leading, leading};
#else
    int zeros = 0;
    if (x / 0x10000u == 0) {
        x *= 0x10000u;
        zeros = 16;
    }
    if (x / 0x1000000u == 0) {
        x *= 0x100u;
        zeros += 8;
    }
    if (x / 0x10000000u == 0) {
        x *= 0x10u;
        zeros += 4;
    }
    if (x / 0x40000000u == 0) {
        x *= 4u;
        zeros += 2;
    }
    if (x / 0x80000000u == 0) {
        x *= 2u;
        zeros += 1;
    }
    return (normal_t){x, zeros};
#endif
}

/* floor(x 2^-shift) */
/*@ requires 0 <= shift <= 31;
    assigns \nothing;
*/
static inline uint32_t shifted_down(uint32_t x, int shift)
{
#ifdef __AVR__ /* it shifts bit by bit, but whole bytes at once */
    if (shift >= 16) {
        x >>= 16;
        shift -= 16;
    }
    if (shift >= 8) {
        x >>= 8;
        shift -= 8;
    }
#endif
    return x >> shift;
}

/* p 2^-shift, at most TERM_MAX. A p that the shift would make larger is a product of normalised
   factors, 2^28 or more, and so beyond TERM_MAX anyhow. */
/*@ assigns \nothing;
    ensures \result <= TERM_MAX;
*/
static inline uint32_t scaled(uint32_t p, int shift)
{
    if (shift < 0 || 31 < shift) {
        return shift < 0 ? TERM_MAX : 0;
    }
    const uint32_t x = shifted_down(p, shift);
    return x < TERM_MAX ? x : TERM_MAX;
}

/* ---- the state: eqs. (12) and (13) --------------------------------------------------------- */

/*
 * zeta' from zeta below z_ss, given how much of the displacement d is plastic: cases 2 and 3.
 */
/*@ requires -STATE_LIMIT < zeta < z_ss < STATE_LIMIT;
    requires 0 <= plastic < d;
    assigns \nothing;

    // Theorem 1: the state is bounded
    ensures \result <= z_ss;
    // Lemma 1: the deflection changes by between nothing and the displacement...
    ensures 0 < \result - zeta <= d;
    // ...strict progress, from which Theorem 2 follows: z_ss is reached exactly, in finitely many steps
    // Lemma 2: plastic displacement has the direction of the motion
    ensures d - (\result - zeta) >= 0;
    // The elastic identity: what is not plastic and stays below z_ss is all deflection, to the unit
    ensures plastic == 0 && zeta + d <= z_ss ==> \result == zeta + d;
    ensures \result == z_ss || \result == zeta + (d - plastic);
*/
static inline int32_t psi(int32_t zeta, int32_t d, int32_t plastic, int32_t z_ss)
{
    const int32_t y = d - plastic;            /* (12) */
    return y < z_ss - zeta ? zeta + y : z_ss; /* (13) */
}

/* ---- the force: eq. (14) ------------------------------------------------------------------- */

/*
 * The force along the motion beyond sigma_0 zeta', in units of 2^8 sigma_0 u: the viscous term and
 * the damping term, each rounded towards zero. In case 1 (zeta' < zeta) the damping term opposes the
 * others and is limited to 1 - 2^-10 of them: the passivity guard.
 */
/*@ requires -STATE_LIMIT < zeta < STATE_LIMIT;
    requires dzeta < 0 ==> zeta > 0; // Theorem 1, in case 1
    requires viscous <= TERM_MAX && damping <= TERM_MAX;
    assigns \nothing;
    ensures -2 * TERM_MAX <= \result <= 2 * TERM_MAX;
    ensures dzeta >= 0 ==> \result == viscous + damping;
    // Theorem 3 in case 1: the guard leaves the force the direction of the motion
    ensures dzeta < 0 ==> zeta + 256 * \result > 0;
*/
static inline int32_t rest_along(int32_t zeta, int32_t dzeta, uint32_t viscous, uint32_t damping)
{
    if (dzeta >= 0) {
        return (int32_t)(viscous + damping);
    }
    const uint32_t others = (uint32_t)zeta / 256u + viscous;
    const uint32_t most = others == 0 ? 0 : others - others / 1024u - 1u;
    return (int32_t)viscous - (int32_t)(damping < most ? damping : most);
}

/* ---- one contact, shared with an interrupt ------------------------------------------------- */

/*@ requires \valid_read(ep) && ep->published <= 1;
    assigns \result \from ep, ep->published;
    ensures \result == &ep->points[ep->published];
*/
static inline const epf_fixed_point_t *published_point(const epf_fixed_t *ep)
{
    return *(const volatile uint8_t *)&ep->published == 0 ? &ep->points[0] : &ep->points[1];
}

/* The other one, for the velocity context to write */
/*@ requires \valid(ep) && ep->published <= 1;
    assigns \result \from ep, ep->published;
    ensures \result == &ep->points[1 - ep->published];
*/
static inline epf_fixed_point_t *point_aside(epf_fixed_t *ep)
{
    return &ep->points[1u - ep->published];
}

/* Volatile accesses keep their order: the index follows the point that it announces */
/*@ requires \valid(ep) && ep->published <= 1;
    assigns ep->published;
    ensures ep->published == 1 - \old(ep->published);
*/
static inline void publish_point(epf_fixed_t *ep)
{
    *(volatile uint8_t *)&ep->published = (uint8_t)(1u - ep->published);
}

/*@ requires \valid(ep);
    assigns ep->force;
    ensures ep->force == force;
*/
static inline void publish_force(epf_fixed_t *ep, int32_t force)
{
    *(volatile int32_t *)&ep->force = force;
}

/*@ requires \valid_read(ep);
    assigns \nothing;
    ensures \result == ep->force;
*/
static inline int32_t published_force(const epf_fixed_t *ep)
{
    return *(const volatile int32_t *)&ep->force;
}

/* A motion in that direction brings the state to z */
/*@ requires \valid(ep) && -STATE_LIMIT < ep->z < STATE_LIMIT && -STATE_LIMIT < z < STATE_LIMIT;
    assigns ep->direction, ep->dz, ep->z;
    ensures ep->direction == direction;
    ensures ep->z == z && \result == z;
    ensures ep->dz == z - \old(ep->z);
*/
static inline int32_t move_to(epf_fixed_t *ep, int8_t direction, int32_t z)
{
    ep->direction = direction;
    ep->dz = z - ep->z;
    ep->z = z;
    return z;
}

/* A displacement of 0 leaves z where it is */
/*@ requires \valid(ep);
    assigns ep->direction, ep->dz;
    ensures ep->direction == 0 && ep->dz == 0 && \result == ep->z;
*/
static inline int32_t stay(epf_fixed_t *ep)
{
    ep->direction = 0;
    ep->dz = 0;
    return ep->z;
}

/* The damping term needs a time: without one it is 0, and counted */
/*@ requires \valid(ep);
    assigns ep->rejected;
    ensures \result != 0 <==> dt != 0;
    ensures ep->rejected >= \old(ep->rejected);
*/
static inline int has_time(epf_fixed_t *ep, uint32_t dt)
{
    if (dt == 0 && ep->rejected != UINT16_MAX) { /* never decreasing: saturates */
        ep->rejected++;
    }
    return dt != 0;
}

/* The force beyond sigma_0 z, signed, of the last displacement */
/*@ requires \valid_read(ep) && valid_coeffs(ep->coeffs) && valid_motion(ep);
    requires -TERM_MAX <= viscous <= TERM_MAX && damping <= TERM_MAX;
    assigns \nothing;
    ensures -2 * TERM_MAX <= \result <= 2 * TERM_MAX;
    ensures ep->direction == 0 ==> \result == viscous;
    // Theorem 3 in case 1, in the signs of the signals
    ensures ep->direction * ep->dz < 0 ==> ep->direction * (ep->z + 256 * \result) > 0;
    // in the other cases both terms go along the motion
    ensures ep->direction * ep->dz >= 0 ==> ep->direction * \result >= 0;
*/
static inline int32_t rest_of_force(const epf_fixed_t *ep, int32_t viscous, uint32_t damping)
{
    const int s = ep->direction;
    if (s == 0) {
        return viscous; /* v' = v */
    }
    return along(s, rest_along(along(s, ep->z), along(s, ep->dz), magnitude(viscous), damping));
}

/*@ requires valid_coeffs(c);
    assigns \nothing;
    ensures -c->z_max <= \result <= c->z_max;
    ensures -c->z_max <= z <= c->z_max ==> \result == z;
*/
static inline int32_t clamped_state(const epf_fixed_coeffs_t *c, int32_t z)
{
    return z > c->z_max ? c->z_max : z < -c->z_max ? -c->z_max : z;
}

/*@ requires \valid(ep);
    assigns ep->z, ep->dz, ep->direction, ep->force;
    ensures ep->z == z && ep->dz == 0 && ep->direction == 0 && ep->force == force;
*/
static inline void put_to(epf_fixed_t *ep, int32_t z, int32_t force)
{
    ep->z = z;
    ep->dz = 0;
    ep->direction = 0;
    publish_force(ep, force);
}

/* Coefficients for a variant whose largest force is that; defined in fixed.c */
epf_status_t epf_fixed_coeffs_init(epf_fixed_coeffs_t *coeffs, const epf_params_t *params,
                                   const epf_lsb_t *lsb, float largest_force);

#endif
