/* SPDX-License-Identifier: MIT */
/*
 * The estimator on 16-bit signals, with products of 16 by 16 bits and no division: for cores that
 * have no more. Read next_along() for the update rule and epf_q15_force() for eq. (14). Fractions
 * are Q15, 2^15 is 1, where nothing else is said; the state keeps its 32 bits.
 */
#include "epf/q15.h"

#include "kernel.h"

#define ONE UINT32_C(32768)

/*@ // At most 16 bits each way, so that no product wraps
    predicate short_inverses(epf_fixed_point_t p) =
      p.inv_z_ss <= 65535 && p.inv_span <= 65535;

    // The largest force fits 16 bits: as epf_q15_coeffs_init makes them
    predicate short_output(epf_fixed_coeffs_t *c) = 41 <= c->output.shift + c->z_shift;

    predicate valid_short_contact(epf_fixed_t *ep) =
      valid_contact(ep) && short_output(ep->coeffs) && short_inverses(ep->points[ep->published]);
*/

/* floor(a b) */
/*@ requires a <= 131071 && b <= ONE;
    assigns \nothing;
    ensures \result <= a;
    ensures a <= ONE ==> \result <= b;
*/
static uint32_t product(uint32_t a, uint32_t b)
{
    /*@ assert a * b <= a * ONE && (a <= ONE ==> a * b <= ONE * b); */
    return a * b / ONE;
}

/* floor(a b/2^16), also where a b takes 48 bits; b is 2^16 at the most */
/*@ assigns \nothing;
    ensures b == 0 ==> \result == 0;
*/
static uint32_t high_product(uint32_t a, uint32_t b)
{
    return a / 65536u * b + a % 65536u * b / 65536u;
}

/* What a share below 1 makes smaller anyhow: the comparison saves the provers a product */
/*@ assigns \nothing;
    ensures \result <= bound;
    ensures x <= bound ==> \result == x;
*/
static uint32_t at_most(uint32_t x, uint32_t bound)
{
    return x < bound ? x : bound;
}

/* p 2^-shift, at most TERM_MAX */
/*@ requires -64 <= shift <= 128;
    assigns \nothing;
    ensures \result <= TERM_MAX;
*/
static uint32_t scaled(uint32_t p, int shift)
{
    if (shift >= 32 || p == 0) {
        return 0;
    }
    if (shift >= 0) {
        p >>= shift;
    } else {
        p = bit_length(p) - shift <= 30 ? p << -shift : TERM_MAX;
    }
    return p < TERM_MAX ? p : TERM_MAX;
}

/* The 16 highest bits of a gain's mantissa; its shift is then 8 less */
/*@ requires gain.mantissa < 16777216;
    assigns \nothing;
*/
static uint16_t mantissa_16(epf_gain_t gain)
{
    return (uint16_t)(gain.mantissa >> 8);
}

/* The reciprocal of a positive x of so many bits, for quotient() */
/*@ requires 0 < x && bits == length(x);
    assigns \nothing;
*/
static uint16_t inverse(uint32_t x, uint8_t bits)
{
    return reciprocal(normalised(x, bits));
}

/* a/x for 0 <= a, from the inverse of x and its number of bits; at most 1 */
/*@ requires a < STATE_LIMIT;
    requires inverse_of_x <= 65535;
    requires 1 <= bits <= 30;
    assigns \nothing;
    ensures \result <= ONE;
*/
static uint32_t quotient(uint32_t a, uint32_t inverse_of_x, uint8_t bits)
{
    uint8_t post = bits;
    if (bits > 16) {
        a >>= bits - 16;
        post = 16;
    }
    if (a >= 65536u) {
        return ONE;
    }
    const uint32_t q = (a * inverse_of_x) >> post;
    return q < ONE ? q : ONE;
}

/* ---- steady state: eqs. (6) to (9) --------------------------------------------------------- */

/* 1/(1 + q), q in Q20, below 2^32 - 2^20; Q16 */
/*@ requires q < 4293918720;
    assigns \nothing;
    ensures \result <= 2 * ONE;
*/
static uint32_t lorentzian(uint32_t q)
{
    const uint32_t x = 1048576u + q;
    const uint8_t bits = bit_length(x);
    return (uint32_t)reciprocal(normalised(x, bits)) >> (bits - 21);
}

/* exp(-q), q in Q20; Q16. As in f32.c: 2^-n times 2^-r, 0 <= r < 1 */
/*@ assigns \nothing;
    ensures \result <= 2 * ONE;
*/
static uint32_t gaussian(uint32_t q)
{
    if (q >= UINT32_C(11) << 20) {
        return 0;
    }
    const uint32_t t = (q >> 8) * 47274u; /* log2 e in Q15; now Q27 */
    const uint32_t n = t >> 27;
    const uint32_t r = (t >> 12) % ONE;
    const uint32_t bend = 6281u - product(r, 1298u); /* 0.19167742 - 0.03962246 r */
    const uint32_t power = ONE - r / 2u - product(product(r, ONE - r), bend);
    return (2u * power) >> n;
}

/* In Q16 */
/*@ requires valid_coeffs(c);
    requires speed <= 32768;
    assigns \nothing;
    ensures \result <= 2 * ONE;
*/
static uint32_t stribeck_weight(const epf_fixed_coeffs_t *c, uint32_t speed)
{
    const uint32_t ratio = /* Q10; 60 v_s and more are as one */
        scaled(speed * mantissa_16(c->v_s_inverse), c->v_s_inverse.shift - 8 - 10);
    const uint32_t r = ratio < 61440u ? ratio : 61440u;
    const uint32_t q = r * r;
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
static int32_t steady_state(const epf_fixed_coeffs_t *c, int16_t v)
{
    if (v == 0) {
        return c->z_max;
    }
    const uint32_t weight = stribeck_weight(c, magnitude(v));
    const uint32_t range = (uint32_t)(c->z_max - c->z_c);
    return c->z_c + (int32_t)at_most(high_product(range, weight), range);
}

/*@ requires valid_coeffs(c);
    assigns \nothing;
    ensures valid_point(c, \result) && short_inverses(\result);
    ensures v > 0 ==> \result.viscous >= 0;
    ensures v == 0 ==> \result.viscous == 0;
    ensures v < 0 ==> \result.viscous <= 0;
*/
static epf_fixed_point_t operating_point(const epf_fixed_coeffs_t *c, int16_t v)
{
    epf_fixed_point_t point;
    point.z_ss = steady_state(c, v);
    const uint32_t span = (uint32_t)(point.z_ss - c->z_ba);
    point.z_ss_bits = bit_length((uint32_t)point.z_ss);
    point.span_bits = bit_length(span);
    point.inv_z_ss = inverse((uint32_t)point.z_ss, point.z_ss_bits);
    point.inv_span = inverse(span, point.span_bits);
    const uint32_t viscous =
        scaled(magnitude(v) * mantissa_16(c->viscous), c->viscous.shift - c->z_shift);
    point.viscous = along(sign(v), (int32_t)viscous);
    return point;
}

/* ---- plasticity: eq. (10) ------------------------------------------------------------------ */

/* 1/2 + 1/2 sin(pi (u - 1/2)) for 0 <= u <= 1, within 3e-4, and never falling: as in f32.c with one
   term less, 1.5684085 - 0.6167798 x^2 */
/*@ requires u <= ONE;
    assigns \nothing;
    ensures \result <= ONE;
*/
static uint32_t half_sine(uint32_t u)
{
    const uint32_t x = u < ONE / 2u ? u : ONE - u;
    const uint32_t slope = 102787u - ((x * x >> 14) * 40421u >> 16); /* Q16 */
    const uint32_t sine = x * slope >> 15;                           /* Q16 */
    const uint32_t half = sine * sine >> 17;
    return u < ONE / 2u ? half : ONE - half;
}

/* alpha for zeta > z_ba */
/*@ requires \valid_read(c) && \valid_read(point) && short_inverses(*point);
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
/*@ requires \valid_read(c) && \valid_read(point) && short_inverses(*point);
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

/* floor(k d) */
/*@ requires 0 < d;
    requires k < ONE;
    assigns \nothing;
    ensures 0 <= \result < d; // strict progress
    ensures k == 0 ==> \result == 0;
*/
static int32_t plastic_part(uint32_t k, int32_t d)
{
    return (int32_t)at_most(high_product((uint32_t)d, 2 * k), (uint32_t)d - 1u);
}

/* ---- the public functions ------------------------------------------------------------------ */

/* zeta' for so many counts of displacement, more than 0, in the direction in which z is zeta */
/*@ requires valid_coeffs(c) && \valid_read(point) && valid_point(c, *point) && short_inverses(*point);
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
    return psi(zeta, d, plastic_part(k, d), point->z_ss);
}

/*@ requires valid_short_contact(ep);
    assigns ep->z, ep->dz, ep->direction;
    // Theorem 1: the state is bounded, by every operating point
    ensures valid_short_contact(ep);
    ensures \result == ep->z;
    ensures dx == 0 ==> ep->z == \old(ep->z);
*/
int32_t epf_q15_advance(epf_q15_t *ep, int16_t dx)
{
    const int s = sign(dx);
    int32_t zeta = along(s, ep->z);
    if (s != 0) {
        zeta = next_along(ep->coeffs, published_point(ep), zeta, magnitude(dx));
    }
    return move_to(ep, s, zeta);
}

/*@ requires valid_body(ep) && short_output(ep->coeffs);
    assigns ep->points[0 .. 1], ep->published;
    ensures valid_short_contact(ep);
*/
void epf_q15_set_velocity(epf_q15_t *ep, int16_t v)
{
    publish_point(ep, operating_point(ep->coeffs, v));
}

/*@ requires valid_short_contact(ep);
    assigns ep->points[0 .. 1], ep->published, ep->z, ep->dz, ep->direction;
    ensures valid_short_contact(ep);
    ensures \result == ep->z;
*/
int32_t epf_q15_update(epf_q15_t *ep, int16_t dx, int16_t v)
{
    epf_q15_set_velocity(ep, v);
    return epf_q15_advance(ep, dx);
}

/* |sigma_1 dz/dt| in units of 2^8 sigma_0 u */
/*@ requires valid_coeffs(c);
    requires -2 * c->z_max <= dz <= 2 * c->z_max;
    requires 0 < dt;
    assigns \nothing;
    ensures \result <= TERM_MAX;
*/
static uint32_t damping(const epf_fixed_coeffs_t *c, int32_t dz, uint16_t dt)
{
    const uint32_t distance = magnitude(dz);
    if (distance == 0) {
        return 0;
    }
    const uint8_t distance_bits = bit_length(distance);
    const uint8_t dt_bits = bit_length(dt);
    const uint32_t inverse_of_dt = reciprocal(normalised(dt, dt_bits)); /* 2^(15 + bits)/dt */
    const uint32_t p = (uint32_t)normalised(distance, distance_bits) * mantissa_16(c->damping);
    return scaled((p >> 16) * inverse_of_dt, c->damping.shift + 15 + dt_bits - distance_bits);
}

/* sigma_0 z + 2^8 rest in lsb.f, to the nearest, saturating */
/*@ requires valid_coeffs(c) && short_output(c);
    requires -STATE_LIMIT < z < STATE_LIMIT && -2 * TERM_MAX <= rest <= 2 * TERM_MAX;
    assigns \nothing;
    ensures -32767 <= \result <= 32767;
*/
static int16_t in_lsb(const epf_fixed_coeffs_t *c, int32_t z, int32_t rest)
{
    const int32_t force = along(sign(z), (int32_t)(magnitude(z) / 256u)) + rest;
    const uint32_t p = high_product(magnitude(force), mantissa_16(c->output));
    const int shift = c->output.shift + c->z_shift - 40; /* 5 at the least, since f_max fits */
    const uint32_t rounded = ((p >> (shift - 1)) + 1u) / 2u;
    const int16_t most = (int16_t)(rounded < INT16_MAX ? rounded : INT16_MAX);
    return (int16_t)(force < 0 ? -most : most);
}

/*@ requires valid_short_contact(ep);
    assigns ep->force, ep->rejected;
    ensures valid_short_contact(ep);
    ensures -32767 <= \result <= 32767;
    ensures ep->force == \result;
*/
int16_t epf_q15_force(epf_q15_t *ep, uint16_t dt)
{
    const epf_fixed_coeffs_t *c = ep->coeffs;
    const uint32_t damped = has_time(ep, dt) ? damping(c, ep->dz, dt) : 0;
    const int32_t rest = rest_of_force(ep, published_point(ep)->viscous, damped);
    const int16_t force = in_lsb(c, ep->z, rest); /* (14) */
    publish_force(ep, force);
    return force;
}

/*@ requires valid_short_contact(ep);
    assigns *ep;
    ensures valid_short_contact(ep);
    ensures -32767 <= \result <= 32767;
*/
int16_t epf_q15_step(epf_q15_t *ep, int16_t dx, int16_t v, uint16_t dt)
{
    (void)epf_q15_update(ep, dx, v);
    return epf_q15_force(ep, dt);
}

/*@ requires \valid_read(ep);
    assigns \nothing;
*/
int16_t epf_q15_output(const epf_q15_t *ep)
{
    return (int16_t)published_force(ep);
}

/*@ requires \valid_read(ep);
    assigns \nothing;
    ensures \result == ep->z;
*/
int32_t epf_q15_z(const epf_q15_t *ep)
{
    return ep->z;
}

/*@ requires valid_coeffs(coeffs) && short_output(coeffs);
    assigns \nothing;
*/
int16_t epf_q15_fss(const epf_q15_coeffs_t *coeffs, int16_t v)
{
    return (int16_t)along(sign(v), in_lsb(coeffs, steady_state(coeffs, v), 0));
}

/*@ requires valid_coeffs(coeffs);
    assigns \nothing;
    ensures 0 <= \result <= STATE_LIMIT; // 0 to 1 in Q30
*/
int32_t epf_q15_alpha(const epf_q15_coeffs_t *coeffs, int32_t z, int16_t v)
{
    const epf_fixed_point_t point = operating_point(coeffs, v);
    const int32_t zeta = along(sign(v), clamped_state(coeffs, z));
    if (zeta <= coeffs->z_ba) {
        return 0;
    }
    return zeta < point.z_ss ? (int32_t)(alpha_at(coeffs, &point, zeta) * ONE) : STATE_LIMIT;
}

epf_status_t epf_q15_coeffs_init(epf_q15_coeffs_t *coeffs, const epf_params_t *params,
                                 const epf_lsb_t *lsb)
{
    return epf_fixed_coeffs_init(coeffs, params, lsb, EPF_Q15_LARGEST_);
}

/*@ requires \valid(ep) && valid_coeffs(coeffs) && short_output(coeffs) && \separated(ep, coeffs);
    assigns *ep;
    ensures valid_short_contact(ep);
    ensures ep->z == 0 && ep->coeffs == coeffs;
*/
void epf_q15_init(epf_q15_t *ep, const epf_q15_coeffs_t *coeffs)
{
    ep->coeffs = coeffs;
    ep->rejected = 0;
    ep->published = 0;
    put_to(ep, 0, 0);
    epf_q15_set_velocity(ep, 0);
}

/*@ requires valid_short_contact(ep);
    assigns ep->z, ep->dz, ep->direction, ep->force;
    ensures valid_short_contact(ep);
*/
void epf_q15_reset(epf_q15_t *ep, int32_t z)
{
    const int32_t clamped = clamped_state(ep->coeffs, z);
    put_to(ep, clamped, in_lsb(ep->coeffs, clamped, 0));
}
