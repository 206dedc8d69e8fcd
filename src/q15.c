/* SPDX-License-Identifier: MIT */
/*
 * The estimator on 16-bit signals, with products of 16 by 16 bits and no division: for cores that
 * have no more. Read next_along() for the update rule and epf_q15_force() for eq. (14). Fractions
 * are Q15, 2^15 is 1, where nothing else is said; the state keeps its 32 bits.
 */
#include "epf/q15.h"

#include "kernel.h"

#define ONE UINT32_C(32768)

/*@ requires a <= 131071 && b <= ONE;
    assigns \nothing;
    ensures \result <= a;
*/
static uint32_t product(uint32_t a, uint32_t b)
{
    return a * b / ONE;
}

/* floor(a b/2^16), also where a b takes 48 bits */
/*@ requires b <= 65535;
    assigns \nothing;
    ensures \result <= a;
*/
static uint32_t high_product(uint32_t a, uint32_t b)
{
    return (a / 65536u) * b + (a % 65536u) * b / 65536u;
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
static uint16_t mantissa_16(epf_gain_t gain)
{
    return (uint16_t)(gain.mantissa >> 8);
}

/* The reciprocal of a positive x of so many bits, for quotient() */
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
static uint32_t lorentzian(uint32_t q)
{
    const uint32_t x = 1048576u + q;
    const uint8_t bits = bit_length(x);
    return (uint32_t)reciprocal(normalised(x, bits)) >> (bits - 21);
}

/* exp(-q), q in Q20; Q16. As in f32.c: 2^-n times 2^-r, 0 <= r < 1 */
static uint32_t gaussian(uint32_t q)
{
    if (q >= UINT32_C(11) << 20) {
        return 0;
    }
    const uint32_t t = (q >> 8) * 47274u; /* log2 e in Q15; now Q27 */
    const uint32_t n = t >> 27;
    const uint32_t r = (t >> 12) & (ONE - 1u);
    const uint32_t bend = 6281u - product(r, 1298u); /* 0.19167742 - 0.03962246 r */
    const uint32_t power = ONE - r / 2u - product(product(r, ONE - r), bend);
    return (2u * power) >> n;
}

/* In Q16 */
static uint32_t stribeck_weight(const epf_fixed_coeffs_t *c, uint32_t speed)
{
    const uint32_t ratio = /* Q10; 60 v_s and more are as one */
        scaled(speed * mantissa_16(c->v_s_inverse), c->v_s_inverse.shift - 8 - 10);
    const uint32_t r = ratio < 61440u ? ratio : 61440u;
    const uint32_t q = r * r;
    switch (c->stribeck) {
    case EPF_STRIBECK_COULOMB:
        return 0; /* (6) */
    case EPF_STRIBECK_GAUSSIAN:
        return gaussian(q); /* (7) */
    case EPF_STRIBECK_LORENTZIAN:
    default:
        return lorentzian(q); /* (8) */
    }
}

/* |z_ss(v)|, eq. (9) */
static int32_t steady_state(const epf_fixed_coeffs_t *c, int16_t v)
{
    if (v == 0) {
        return c->z_max;
    }
    const uint32_t weight = stribeck_weight(c, magnitude(v));
    return c->z_c + (int32_t)high_product((uint32_t)(c->z_max - c->z_c), weight);
}

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
static uint32_t alpha_at(const epf_fixed_coeffs_t *c, const epf_fixed_point_t *point, int32_t zeta)
{
    return half_sine(quotient((uint32_t)(zeta - c->z_ba), point->inv_span, point->span_bits));
}

/* alpha zeta/z_ss for zeta > z_ba, below 1: at 1 the state would stick under z_ss */
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
    ensures 0 <= \result < d;
    ensures k == 0 ==> \result == 0;
*/
static int32_t plastic_part(uint32_t k, int32_t d)
{
    return (int32_t)high_product((uint32_t)d, 2 * k);
}

/* ---- the public functions ------------------------------------------------------------------ */

/* zeta' for so many counts of displacement, more than 0, in the direction in which z is zeta */
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

int32_t epf_q15_advance(epf_q15_t *ep, int16_t dx)
{
    const int s = sign(dx);
    int32_t zeta = along(s, ep->z);
    if (s != 0) {
        zeta = next_along(ep->coeffs, published_point(ep), zeta, magnitude(dx));
    }
    return move_to(ep, s, zeta);
}

void epf_q15_set_velocity(epf_q15_t *ep, int16_t v)
{
    publish_point(ep, operating_point(ep->coeffs, v));
}

int32_t epf_q15_update(epf_q15_t *ep, int16_t dx, int16_t v)
{
    epf_q15_set_velocity(ep, v);
    return epf_q15_advance(ep, dx);
}

/* |sigma_1 dz/dt| in units of 2^8 sigma_0 u */
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
static int16_t in_lsb(const epf_fixed_coeffs_t *c, int32_t z, int32_t rest)
{
    const int32_t force = z / 256 + rest;
    const uint32_t p = high_product(magnitude(force), mantissa_16(c->output));
    const int shift = c->output.shift + c->z_shift - 40; /* 5 at the least, since f_max fits */
    const uint32_t rounded = ((p >> (shift - 1)) + 1u) >> 1;
    const int16_t most = (int16_t)(rounded < INT16_MAX ? rounded : INT16_MAX);
    return (int16_t)(force < 0 ? -most : most);
}

int16_t epf_q15_force(epf_q15_t *ep, uint16_t dt)
{
    const epf_fixed_coeffs_t *c = ep->coeffs;
    const uint32_t damped = has_time(ep, dt) ? damping(c, ep->dz, dt) : 0;
    const int32_t rest = rest_of_force(ep, published_point(ep)->viscous, damped);
    const int16_t force = in_lsb(c, ep->z, rest); /* (14) */
    publish_force(ep, force);
    return force;
}

int16_t epf_q15_step(epf_q15_t *ep, int16_t dx, int16_t v, uint16_t dt)
{
    (void)epf_q15_update(ep, dx, v);
    return epf_q15_force(ep, dt);
}

int16_t epf_q15_output(const epf_q15_t *ep)
{
    return (int16_t)published_force(ep);
}

int32_t epf_q15_z(const epf_q15_t *ep)
{
    return ep->z;
}

int16_t epf_q15_fss(const epf_q15_coeffs_t *coeffs, int16_t v)
{
    return (int16_t)along(sign(v), in_lsb(coeffs, steady_state(coeffs, v), 0));
}

int32_t epf_q15_alpha(const epf_q15_coeffs_t *coeffs, int32_t z, int16_t v)
{
    const epf_fixed_point_t point = operating_point(coeffs, v);
    const int32_t zeta = along(sign(v), clamped_state(coeffs, z));
    if (zeta <= coeffs->z_ba) {
        return 0;
    }
    return zeta < point.z_ss ? (int32_t)(alpha_at(coeffs, &point, zeta) << 15) : STATE_LIMIT;
}

epf_status_t epf_q15_coeffs_init(epf_q15_coeffs_t *coeffs, const epf_params_t *params,
                                 const epf_lsb_t *lsb)
{
    return epf_fixed_coeffs_init(coeffs, params, lsb, EPF_Q15_LARGEST_);
}

void epf_q15_init(epf_q15_t *ep, const epf_q15_coeffs_t *coeffs)
{
    *ep = (epf_q15_t){.coeffs = coeffs};
    epf_q15_set_velocity(ep, 0);
}

void epf_q15_reset(epf_q15_t *ep, int32_t z)
{
    const int32_t clamped = clamped_state(ep->coeffs, z);
    put_to(ep, clamped, in_lsb(ep->coeffs, clamped, 0));
}
