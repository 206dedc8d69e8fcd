/* SPDX-License-Identifier: MIT */
/*
 * The estimator on 32-bit signals, with 64-bit products. Read next_along() for the update rule and
 * internal_force() for eq. (14). Fractions are Q30: 2^30 is 1.
 */
#include "epf/q31.h"

#include "kernel.h"

#define ONE UINT32_C(1073741824)

/* floor(a b) */
/*@ requires b <= ONE;
    assigns \nothing;
    ensures \result <= a;
    ensures a <= ONE ==> \result <= b;
    ensures b <= ONE / 2 ==> 2 * \result <= a;
    ensures 0 < a && b < ONE ==> \result < a; // strict progress
    ensures b == 0 ==> \result == 0;
*/
static uint32_t product(uint32_t a, uint32_t b)
{
    return (uint32_t)((uint64_t)a * b / ONE);
}

/* x times the mantissa of a gain */
/*@ requires x <= 2147483648 && gain.mantissa < 16777216;
    assigns \nothing;
    ensures \result < 36028797018963968; // 2^55
*/
static uint64_t by_mantissa(uint32_t x, epf_gain_t gain)
{
    return (uint64_t)x * gain.mantissa;
}

/* p 2^-shift, at most TERM_MAX; p < 2^60 */
/*@ requires p < 1152921504606846976;
    requires -32 <= shift;
    assigns \nothing;
    ensures \result <= TERM_MAX;
*/
static uint32_t scaled(uint64_t p, int shift)
{
    if (shift >= 64 || p == 0) {
        return 0;
    }
    const uint64_t x = shift >= 0 ? p >> shift : p < TERM_MAX ? p << -shift : TERM_MAX;
    return x < TERM_MAX ? (uint32_t)x : TERM_MAX;
}

/* About 2^63/m, below 2^32, for 2^31 <= m < 2^32: one step of Newton's iteration after 16 bits */
/*@ requires 2147483648 <= m;
    assigns \nothing;
*/
static uint32_t reciprocal_32(uint32_t m)
{
    const uint32_t x = (uint32_t)reciprocal((uint16_t)(m >> 16)) << 16;
    const uint32_t error = (uint32_t)(((uint64_t)m * x) >> 32); /* 2^31 m x/2^63 */
    const uint64_t y = ((uint64_t)x * (0u - error)) >> 31;
    return y < UINT32_MAX ? (uint32_t)y : UINT32_MAX;
}

/* The reciprocal of a positive x of so many bits, for quotient() */
/*@ requires 0 < x && bits == length(x);
    assigns \nothing;
*/
static uint32_t inverse(uint32_t x, uint8_t bits)
{
    return reciprocal_32(x << (32 - bits));
}

/* a/x for 0 <= a, from the inverse of x and its number of bits; at most 1 */
/*@ requires 1 <= bits <= 30;
    assigns \nothing;
    ensures \result <= ONE;
*/
static uint32_t quotient(uint32_t a, uint32_t inverse_of_x, uint8_t bits)
{
    const uint64_t q = ((uint64_t)a * inverse_of_x) >> (bits + 1);
    return q < ONE ? (uint32_t)q : ONE;
}

/* ---- steady state: eqs. (6) to (9) --------------------------------------------------------- */

/* 1/(1 + q), q in Q36 */
/*@ assigns \nothing;
    ensures \result <= ONE;
*/
static uint32_t lorentzian(uint64_t q)
{
    const uint64_t x = ((uint64_t)1 << 32) + (q >> 4); /* 1 + q, at least 33 bits */
    const uint8_t bits = bit_length((uint32_t)(x / 4294967296u));
    return reciprocal_32((uint32_t)(x >> bits)) >> (bits + 1);
}

/* exp(-q), q in Q36: 2^-n times 2^-r, 0 <= r < 1, by a polynomial that is exact at both ends */
/*@ assigns \nothing;
    ensures \result <= ONE;
*/
static uint32_t gaussian(uint64_t q)
{
    if (q >= (uint64_t)22 << 36) {
        return 0;
    }
    const uint64_t t = (q >> 10) * 3098164009u; /* log2 e in Q31; now Q57 */
    /*@ assert t / 144115188075855872 < 32; */
    const uint32_t n = (uint32_t)(t >> 57);
    const uint32_t r = (uint32_t)(t >> 27) % ONE;
    /* 0.19314418 - r (0.04703982 - r (0.00826757 - r 0.00094842)) */
    const uint32_t bend =
        207386989u - product(r, 50508625u - product(r, 8877239u - product(r, 1018363u)));
    const uint32_t power = ONE - r / 2u - product(product(r, ONE - r), bend);
    /*@ assert power <= ONE && n < 32 && (power >> n) <= power; */
    return power >> n;
}

/*@ requires valid_coeffs(c);
    requires speed <= 2147483648;
    assigns \nothing;
    ensures \result <= ONE;
*/
static uint32_t stribeck_weight(const epf_fixed_coeffs_t *c, uint32_t speed)
{
    const uint32_t ratio =
        scaled(by_mantissa(speed, c->v_s_inverse), c->v_s_inverse.shift - 18); /* Q18 */
    const uint64_t q = (uint64_t)ratio * ratio;
    if (c->stribeck == EPF_STRIBECK_COULOMB) {
        return 0; /* (6) */
    }
    return c->stribeck == EPF_STRIBECK_GAUSSIAN ? gaussian(q) : lorentzian(q); /* (7), (8) */
}

/* |z_ss(v)|, eq. (9) */
/*@ requires valid_coeffs(c);
    assigns \nothing;
    ensures c->z_c <= \result <= c->z_max;
    ensures v == 0 ==> \result == c->z_max;
*/
static int32_t steady_state(const epf_fixed_coeffs_t *c, int32_t v)
{
    if (v == 0) {
        return c->z_max;
    }
    const uint32_t weight = stribeck_weight(c, magnitude(v));
    return c->z_c + (int32_t)product((uint32_t)(c->z_max - c->z_c), weight);
}

/*@ requires valid_coeffs(c);
    assigns \nothing;
    ensures valid_point(c, \result);
    ensures v > 0 ==> \result.viscous >= 0;
    ensures v == 0 ==> \result.viscous == 0;
    ensures v < 0 ==> \result.viscous <= 0;
*/
static epf_fixed_point_t operating_point(const epf_fixed_coeffs_t *c, int32_t v)
{
    epf_fixed_point_t point;
    point.z_ss = steady_state(c, v);
    const uint32_t span = (uint32_t)(point.z_ss - c->z_ba);
    point.z_ss_bits = bit_length((uint32_t)point.z_ss);
    point.span_bits = bit_length(span);
    point.inv_z_ss = inverse((uint32_t)point.z_ss, point.z_ss_bits);
    point.inv_span = inverse(span, point.span_bits);
    const uint32_t viscous =
        scaled(by_mantissa(magnitude(v), c->viscous), c->viscous.shift + 8 - c->z_shift);
    point.viscous = along(sign(v), (int32_t)viscous);
    return point;
}

/* ---- plasticity: eq. (10) ------------------------------------------------------------------ */

/* 1/2 + 1/2 sin(pi (u - 1/2)) for 0 <= u <= 1: the polynomial of f32.c */
/*@ requires u <= ONE;
    assigns \nothing;
    ensures \result <= ONE;
*/
static uint32_t half_sine(uint32_t u)
{
    const uint32_t x = u < ONE / 2u ? u : ONE - u;
    const uint32_t q = product(x, x);
    const uint32_t slope = 1686614170u - product(693230716u - product(83100150u, q), q);
    const uint32_t sine = product(slope, x);
    const uint32_t half = product(sine, sine);
    return u < ONE / 2u ? half : ONE - half;
}

/* alpha for zeta > z_ba */
/*@ requires \valid_read(c) && \valid_read(point);
    requires 0 < c->z_ba < zeta < STATE_LIMIT;
    requires 1 <= point->span_bits <= 30;
    assigns \nothing;
    ensures \result <= ONE;
*/
static uint32_t alpha_at(const epf_fixed_coeffs_t *c, const epf_fixed_point_t *point, int32_t zeta)
{
    return half_sine(quotient((uint32_t)(zeta - c->z_ba), point->inv_span, point->span_bits));
}

/* alpha zeta/z_ss for zeta > z_ba, below 1: at 1 the state would stick under z_ss */
/*@ requires \valid_read(c) && \valid_read(point);
    requires 0 < c->z_ba < zeta < STATE_LIMIT;
    requires 1 <= point->span_bits <= 30 && 1 <= point->z_ss_bits <= 30;
    assigns \nothing;
    ensures \result < ONE; // strict progress
*/
static uint32_t plastic_share(const epf_fixed_coeffs_t *c, const epf_fixed_point_t *point,
                              int32_t zeta)
{
    const uint32_t ratio = quotient((uint32_t)zeta, point->inv_z_ss, point->z_ss_bits);
    const uint32_t k = product(alpha_at(c, point, zeta), ratio);
    return k < ONE ? k : ONE - 1u;
}

/* ---- the public functions ------------------------------------------------------------------ */

/* zeta' for so many counts of displacement, more than 0, in the direction in which z is zeta */
/*@ requires valid_coeffs(c) && \valid_read(point) && valid_point(c, *point);
    requires -c->z_max <= zeta <= c->z_max;
    requires 0 < counts <= 2147483648;
    assigns \nothing;

    // Theorem 1: the state is bounded
    ensures -c->z_max <= \result <= point->z_ss;
    // Lemma 1: below z_ss the deflection changes by between nothing and the displacement, and
    // strictly: Theorem 2
    ensures zeta < point->z_ss ==> 0 < \result - zeta <= (counts << c->z_shift);
    ensures zeta >= point->z_ss ==> \result == point->z_ss;
    // Lemma 2: plastic displacement has the direction of the motion, and needs more than z_ba
    ensures (counts << c->z_shift) - (\result - zeta) >= 0;
    ensures (counts << c->z_shift) - (\result - zeta) > 0 ==> \result > c->z_ba;
    // The elastic identity, to the unit: no drift
    ensures zeta + (counts << c->z_shift) <= c->z_ba ==>
              \result == zeta + (counts << c->z_shift);
    // Theorem 2: a displacement of 2 z_max arrives at once
    ensures (counts << c->z_shift) >= 2 * c->z_max ==> \result == point->z_ss;
*/
static int32_t next_along(const epf_fixed_coeffs_t *c, const epf_fixed_point_t *point, int32_t zeta,
                          uint32_t counts)
{
    if (counts > leap_limit(c)) {
        return point->z_ss;
    }
    const int32_t d = (int32_t)(counts << c->z_shift);
    const uint32_t k = zeta <= c->z_ba ? 0 : plastic_share(c, point, zeta);
    return psi(zeta, d, (int32_t)product((uint32_t)d, k), point->z_ss);
}

/*@ requires valid_contact(ep);
    assigns ep->z, ep->dz, ep->direction;
    // Theorem 1: the state is bounded, by every operating point
    ensures valid_contact(ep);
    ensures \result == ep->z;
    ensures dx == 0 ==> ep->z == \old(ep->z);
*/
int32_t epf_q31_advance(epf_q31_t *ep, int32_t dx)
{
    const int s = sign(dx);
    int32_t zeta = along(s, ep->z);
    if (s != 0) {
        zeta = next_along(ep->coeffs, published_point(ep), zeta, magnitude(dx));
    }
    return move_to(ep, s, zeta);
}

/*@ requires valid_body(ep);
    assigns ep->points[0 .. 1], ep->published;
    ensures valid_contact(ep);
*/
void epf_q31_set_velocity(epf_q31_t *ep, int32_t v)
{
    publish_point(ep, operating_point(ep->coeffs, v));
}

/*@ requires valid_contact(ep);
    assigns ep->points[0 .. 1], ep->published, ep->z, ep->dz, ep->direction;
    ensures valid_contact(ep);
    ensures \result == ep->z;
*/
int32_t epf_q31_update(epf_q31_t *ep, int32_t dx, int32_t v)
{
    epf_q31_set_velocity(ep, v);
    return epf_q31_advance(ep, dx);
}

/* |sigma_1 dz/dt| in units of 2^8 sigma_0 u */
/*@ requires valid_coeffs(c);
    requires -2 * c->z_max <= dz <= 2 * c->z_max;
    requires 0 < dt;
    assigns \nothing;
    ensures \result <= TERM_MAX;
*/
static uint32_t damping(const epf_fixed_coeffs_t *c, int32_t dz, uint32_t dt)
{
    const uint8_t bits = bit_length(dt);
    const uint32_t inverse_of_dt = reciprocal(normalised(dt, bits)); /* 2^(15 + bits)/dt */
    const uint64_t p = by_mantissa(magnitude(dz), c->damping);
    /*@ assert p / 2048 * inverse_of_dt <= p / 2048 * 65535; */
    return scaled(p / 2048u * inverse_of_dt, c->damping.shift + 12 + bits);
}

/* sigma_0 z + 2^8 rest in lsb.f, to the nearest, saturating */
/*@ requires valid_coeffs(c);
    requires -STATE_LIMIT < z < STATE_LIMIT && -2 * TERM_MAX <= rest <= 2 * TERM_MAX;
    assigns \nothing;
    ensures -2147483647 <= \result <= 2147483647;
    // Theorem 3 on the output: it never has the other sign
    ensures z + 256 * rest > 0 ==> \result >= 0;
    ensures z + 256 * rest < 0 ==> \result <= 0;
*/
static int32_t in_lsb(const epf_fixed_coeffs_t *c, int32_t z, int32_t rest)
{
    const int64_t force = (int64_t)z + 256 * (int64_t)rest;
    const uint64_t p = (uint64_t)(force < 0 ? -force : force) * c->output.mantissa;
    const int shift = c->output.shift + c->z_shift - 8;
    const uint64_t rounded = ((p >> (shift - 1)) + 1u) / 2u;
    const int32_t most = rounded < INT32_MAX ? (int32_t)rounded : INT32_MAX;
    return force < 0 ? -most : most;
}

/*@ requires valid_contact(ep);
    assigns ep->force, ep->rejected;
    ensures valid_contact(ep);
    ensures -2147483647 <= \result <= 2147483647;
    ensures ep->force == \result;
*/
int32_t epf_q31_force(epf_q31_t *ep, uint32_t dt)
{
    const epf_fixed_coeffs_t *c = ep->coeffs;
    const uint32_t damped = has_time(ep, dt) ? damping(c, ep->dz, dt) : 0;
    const int32_t rest = rest_of_force(ep, published_point(ep)->viscous, damped);
    const int32_t force = in_lsb(c, ep->z, rest); /* (14) */
    publish_force(ep, force);
    return force;
}

/*@ requires valid_contact(ep);
    assigns *ep;
    ensures valid_contact(ep);
    ensures -2147483647 <= \result <= 2147483647;
*/
int32_t epf_q31_step(epf_q31_t *ep, int32_t dx, int32_t v, uint32_t dt)
{
    (void)epf_q31_update(ep, dx, v);
    return epf_q31_force(ep, dt);
}

/*@ requires \valid_read(ep);
    assigns \nothing;
*/
int32_t epf_q31_output(const epf_q31_t *ep)
{
    return published_force(ep);
}

/*@ requires \valid_read(ep);
    assigns \nothing;
    ensures \result == ep->z;
*/
int32_t epf_q31_z(const epf_q31_t *ep)
{
    return ep->z;
}

/*@ requires valid_coeffs(coeffs);
    assigns \nothing;
    ensures v > 0 ==> \result >= 0;
    ensures v == 0 ==> \result == 0;
    ensures v < 0 ==> \result <= 0;
*/
int32_t epf_q31_fss(const epf_q31_coeffs_t *coeffs, int32_t v)
{
    return along(sign(v), in_lsb(coeffs, steady_state(coeffs, v), 0));
}

/*@ requires valid_coeffs(coeffs);
    assigns \nothing;
    ensures 0 <= \result <= STATE_LIMIT; // 0 to 1 in Q30
*/
int32_t epf_q31_alpha(const epf_q31_coeffs_t *coeffs, int32_t z, int32_t v)
{
    const epf_fixed_point_t point = operating_point(coeffs, v);
    const int32_t zeta = along(sign(v), clamped_state(coeffs, z));
    if (zeta <= coeffs->z_ba) {
        return 0;
    }
    return zeta < point.z_ss ? (int32_t)alpha_at(coeffs, &point, zeta) : (int32_t)ONE;
}

epf_status_t epf_q31_coeffs_init(epf_q31_coeffs_t *coeffs, const epf_params_t *params,
                                 const epf_lsb_t *lsb)
{
    return epf_fixed_coeffs_init(coeffs, params, lsb, EPF_Q31_LARGEST_);
}

/*@ requires \valid(ep) && valid_coeffs(coeffs) && \separated(ep, coeffs);
    assigns *ep;
    ensures valid_contact(ep);
    ensures ep->z == 0 && ep->coeffs == coeffs;
*/
void epf_q31_init(epf_q31_t *ep, const epf_q31_coeffs_t *coeffs)
{
    ep->coeffs = coeffs;
    ep->rejected = 0;
    ep->published = 0;
    put_to(ep, 0, 0);
    epf_q31_set_velocity(ep, 0);
}

/*@ requires valid_contact(ep);
    assigns ep->z, ep->dz, ep->direction, ep->force;
    ensures valid_contact(ep);
*/
void epf_q31_reset(epf_q31_t *ep, int32_t z)
{
    const int32_t clamped = clamped_state(ep->coeffs, z);
    put_to(ep, clamped, in_lsb(ep->coeffs, clamped, 0));
}
