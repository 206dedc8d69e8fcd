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
      c->z_shift <= 29 &&
      c->v_s_inverse.mantissa < 16777216 && c->v_s_inverse.shift <= 56 &&
      c->viscous.mantissa < 16777216 && c->viscous.shift <= 56 &&
      c->damping.mantissa < 16777216 && c->damping.shift <= 56 &&
      c->output.mantissa < 16777216 && 9 <= c->output.shift + c->z_shift <= 72;

    // An operating point of some velocity
    predicate valid_point(epf_fixed_coeffs_t *c, epf_fixed_point_t p) =
      c->z_c <= p.z_ss <= c->z_max &&
      -TERM_MAX <= p.viscous <= TERM_MAX &&
      1 <= p.z_ss_bits <= 30 && 1 <= p.span_bits <= 30;

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
      valid_body(ep) && valid_point(ep->coeffs, ep->points[ep->published]);
*/

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

/*@ assigns \nothing;
    ensures x > 0 ==> \result == 1;
    ensures x == 0 ==> \result == 0;
    ensures x < 0 ==> \result == -1;
*/
static inline int sign(int32_t x)
{
    return (x > 0) - (x < 0);
}

/* s x: x as seen in the direction s */
/*@ requires s == -1 || s == 0 || s == 1;
    requires -2147483647 <= x;
    assigns \nothing;
    ensures \result == s * x;
*/
static inline int32_t along(int s, int32_t x)
{
    return s > 0 ? x : s < 0 ? -x : 0;
}

/* How many bits x has: the position of its highest one, 0 for 0 */
/*@ logic integer length(integer x) =
      x < 1 ? 0 : x < 2 ? 1 : x < 4 ? 2 : x < 8 ? 3 : x < 16 ? 4 : x < 32 ? 5 : x < 64 ? 6 :
      x < 128 ? 7 : x < 256 ? 8 : x < 512 ? 9 : x < 1024 ? 10 : x < 2048 ? 11 : x < 4096 ? 12 :
      x < 8192 ? 13 : x < 16384 ? 14 : x < 32768 ? 15 : x < 65536 ? 16 : x < 131072 ? 17 :
      x < 262144 ? 18 : x < 524288 ? 19 : x < 1048576 ? 20 : x < 2097152 ? 21 :
      x < 4194304 ? 22 : x < 8388608 ? 23 : x < 16777216 ? 24 : x < 33554432 ? 25 :
      x < 67108864 ? 26 : x < 134217728 ? 27 : x < 268435456 ? 28 : x < 536870912 ? 29 :
      x < 1073741824 ? 30 : x < 2147483648 ? 31 : 32;
*/
/*@ assigns \nothing;
    ensures \result == length(x);
*/
static inline uint8_t bit_length(uint32_t x)
{
    uint8_t bits = 0;
    if (x >= 65536u) {
        x /= 65536u;
        bits = 16;
    }
    /*@ assert length(\at(x, Pre)) == bits + length(x) && x < 65536 && bits <= 16; */
    if (x >= 256u) {
        x /= 256u;
        bits = (uint8_t)(bits + 8);
    }
    /*@ assert length(\at(x, Pre)) == bits + length(x) && x < 256 && bits <= 24; */
    if (x >= 16u) {
        x /= 16u;
        bits = (uint8_t)(bits + 4);
    }
    /*@ assert length(\at(x, Pre)) == bits + length(x) && x < 16 && bits <= 28; */
    if (x >= 4u) {
        x /= 4u;
        bits = (uint8_t)(bits + 2);
    }
    /*@ assert length(\at(x, Pre)) == bits + length(x) && x < 4 && bits <= 30; */
    return (uint8_t)(bits + (x < 2u ? x : 2u));
}

/* x by a power of two to 16 bits, the highest one set; x > 0 */
/*@ requires 0 < x && bits == length(x);
    assigns \nothing;
    ensures 32768 <= \result;
*/
static inline uint16_t normalised(uint32_t x, uint8_t bits)
{
    return (uint16_t)(bits > 16 ? x >> (bits - 16) : x << (16 - bits));
}

/*
 * floor((2^31 - 1)/m) for 2^15 <= m < 2^16, exactly, without a division, which small cores do not
 * have: two steps of Newton's iteration from a straight line, then the remainder settles the rest.
 */
/*@ requires 32768 <= m;
    assigns \nothing;
*/
static inline uint16_t reciprocal(uint16_t m)
{
    uint32_t x = 92517u - (((uint32_t)m * 61681u) >> 16); /* within 1/17 of 2^31/m */
    x = (x * ((0u - m * x) >> 16)) >> 15;                 /* x (2 - m x/2^31): within 1/17^2 */
    x = (x * ((0u - m * x) >> 16)) >> 15;                 /* 1/17^4, from below */
    uint32_t remainder = 2147483647u - m * x;
    /*@ loop assigns x, remainder;
        loop variant remainder;
    */
    while (remainder >= m) {
        x++;
        remainder -= m;
    }
    return (uint16_t)x;
}

/* ---- the state: eqs. (12) and (13) --------------------------------------------------------- */

/*
 * zeta' from zeta, given how much of the displacement d is plastic.
 */
/*@ requires -STATE_LIMIT < zeta < STATE_LIMIT;
    requires 0 < z_ss < STATE_LIMIT;
    requires 0 <= plastic < d;
    assigns \nothing;

    // Theorem 1: the state is bounded
    ensures -STATE_LIMIT < \result <= z_ss;
    ensures zeta <= z_ss ==> zeta <= \result;
    // Lemma 1: below z_ss the deflection changes by between nothing and the displacement...
    ensures zeta < z_ss ==> 0 < \result - zeta <= d;
    // ...strict progress, from which Theorem 2 follows: z_ss is reached exactly, in finitely many steps
    // Lemma 2: plastic displacement has the direction of the motion
    ensures d - (\result - zeta) >= 0;
    // The elastic identity: what is not plastic and stays below z_ss is all deflection, to the unit
    ensures plastic == 0 && zeta + d <= z_ss ==> \result == zeta + d;
    ensures \result == z_ss || \result == zeta + (d - plastic);
    // Case 1
    ensures zeta >= z_ss ==> \result == z_ss;
*/
static inline int32_t psi(int32_t zeta, int32_t d, int32_t plastic, int32_t z_ss)
{
    if (zeta >= z_ss) {
        return z_ss; /* case 1 */
    }
    const int32_t y = d - plastic;            /* (12) */
    return y < z_ss - zeta ? zeta + y : z_ss; /* (13) */
}

/* The largest number of counts that is not a leap: from 2 z_max on, every state ends in z_ss */
/*@ requires valid_coeffs(c);
    assigns \nothing;
    ensures \forall integer n; n <= \result <==> (n << c->z_shift) < 2 * c->z_max;
*/
static inline uint32_t leap_limit(const epf_fixed_coeffs_t *c)
{
    return (2u * (uint32_t)c->z_max - 1u) >> c->z_shift;
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
    return &ep->points[*(const volatile uint8_t *)&ep->published];
}

/* Volatile accesses keep their order: the index follows the point that it announces */
/*@ requires \valid(ep) && ep->published <= 1;
    // Until the index is written, an interrupt goes on with the point that is published
    assigns ep->points[1 - ep->published].z_ss, ep->points[1 - ep->published].viscous,
            ep->points[1 - ep->published].inv_z_ss, ep->points[1 - ep->published].inv_span,
            ep->points[1 - ep->published].z_ss_bits, ep->points[1 - ep->published].span_bits,
            ep->published;
    ensures ep->published == 1 - \old(ep->published);
    ensures ep->points[ep->published] == point;
*/
static inline void publish_point(epf_fixed_t *ep, epf_fixed_point_t point)
{
    const uint8_t aside = (uint8_t)(1u - ep->published);
    volatile epf_fixed_point_t *target = &ep->points[aside];
    target->z_ss = point.z_ss;
    target->viscous = point.viscous;
    target->inv_z_ss = point.inv_z_ss;
    target->inv_span = point.inv_span;
    target->z_ss_bits = point.z_ss_bits;
    target->span_bits = point.span_bits;
    *(volatile uint8_t *)&ep->published = aside;
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

/* Takes zeta' over into the state. A displacement of 0 leaves z where it is. */
/*@ requires \valid(ep) && -STATE_LIMIT < ep->z < STATE_LIMIT && -STATE_LIMIT < zeta < STATE_LIMIT;
    requires -1 <= s <= 1;
    assigns ep->direction, ep->dz, ep->z;
    ensures ep->direction == s;
    ensures ep->z == (s == 0 ? \old(ep->z) : s * zeta);
    ensures ep->dz == ep->z - \old(ep->z);
    ensures \result == ep->z;
*/
static inline int32_t move_to(epf_fixed_t *ep, int s, int32_t zeta)
{
    ep->direction = (int8_t)s;
    if (s == 0) {
        ep->dz = 0;
    } else {
        const int32_t z = along(s, zeta);
        ep->dz = z - ep->z;
        ep->z = z;
    }
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
