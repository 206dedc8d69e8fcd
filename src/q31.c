/* SPDX-License-Identifier: MIT */
/*
 * The estimator on 32-bit signals, with 64-bit products. Read next_along() for the update rule and
 * in_lsb() for eq. (14). Fractions are Q32 where nothing else is said, so that a product is the high
 * word of a multiplication.
 */
#include "epf/q31.h"

#include "kernel.h"

/* The fraction next to 1 stands for 1: no part of a displacement is ever all of it */
#define ONE UINT32_MAX

#ifdef __AVR__ /* where it is too long to stand in line */
static OUT_OF_LINE uint32_t product(uint32_t a, uint32_t b);
#endif
/* floor(a b), of two fractions, or of an integer and a fraction */
/*@ assigns \nothing;
    ensures \result <= a && \result <= b;
    ensures 0 < a ==> \result < a; // strict progress
    ensures b == 0 ==> \result == 0;
*/
static uint32_t product(uint32_t a, uint32_t b)
{
    /*@ assert (integer)a * b <= a * 4294967295 && (integer)a * b <= 4294967295 * b; */
    return (uint32_t)((uint64_t)a * b / 4294967296u);
}

/* 2^32/m in Q30, from below and so less than 2, for 2^31 <= m < 2^32: three steps of Newton's
   iteration, x (2 - m x), from a straight line within 1/17 */
/*@ assigns \nothing; */
static inline uint32_t inverse(uint32_t m)
{
    uint32_t x = 3031741620u - product(m, 2021161080u);
    x = 4u * product(x, 2147483647u - product(m, x));
    x = 4u * product(x, 2147483647u - product(m, x));
    return 4u * product(x, 2147483647u - product(m, x));
}

/* a/x for 0 <= a < x, from below, of the leading zeros of x and the inverse of what is left */
/*@ requires 0 <= zeros <= 31;
    assigns \nothing;
*/
static uint32_t quotient(uint32_t a, uint32_t inverse_of_x, int zeros)
{
    return 4u * product(a << zeros, inverse_of_x);
}

/* 2^power x times a gain, at most TERM_MAX */
/*@ requires gain.mantissa < 16777216;
    requires 0 <= x.zeros <= 31 && 0 <= power <= 32;
    assigns \nothing;
    ensures \result <= TERM_MAX;
*/
static inline uint32_t gained(normal_t x, epf_gain_t gain, int power)
{
    return scaled(product(x.mantissa, 256u * gain.mantissa), gain.shift + x.zeros - 24 - power);
}

/* ---- steady state: eqs. (6) to (9) --------------------------------------------------------- */

/* 1/(1 + q), q in Q36 */
/*@ requires q <= 288230376151711744; // 2^58
    assigns \nothing;
*/
static inline uint32_t lorentzian(uint64_t q)
{
    const uint64_t x = 4294967296u + q / 16u; /* 1 + q in Q32, at least 33 bits */
    const normal_t high = normalised((uint32_t)(x / 4294967296u));
    const int bits = 32 - high.zeros;
    return 4u * (inverse(high.mantissa | (uint32_t)x >> bits) >> bits);
}

/* exp(-q), q in Q36: 2^-n times 2^-r, 0 <= r < 1, by a polynomial that is exact at both ends */
/*@ assigns \nothing; */
static uint32_t gaussian(uint64_t q)
{
    if (q >= (uint64_t)22 << 36) {
        return 0;
    }
    const uint64_t t = (q >> 10) * 3098164009u; /* log2 e in Q31; now Q57 */
    const uint32_t n = (uint32_t)(t / ((uint64_t)1 << 57)) % 32u;
    const uint32_t r = (uint32_t)(t >> 25);
    /* 0.19314418 - r (0.04703982 - r (0.00826757 - r 0.00094842)) */
    const uint32_t bend =
        829547955u - product(r, 202034500u - product(r, 35508957u - product(r, 4073451u)));
    return (ONE - r / 2u - product(product(r, ONE - r), bend)) >> n;
}

/*@ requires valid_coeffs(c);
    requires 0 <= speed.zeros <= 31;
    assigns \nothing;
*/
static inline uint32_t stribeck_weight(const epf_fixed_coeffs_t *c, normal_t speed)
{
    const uint32_t ratio = gained(speed, c->v_s_inverse, 18); /* Q18 */
    const uint64_t q = (uint64_t)ratio * ratio;
    /*@ assert q <= TERM_MAX * TERM_MAX; */
    if (form_in_use(c->stribeck) == EPF_STRIBECK_COULOMB) {
        return 0; /* (6) */
    }
    return form_in_use(c->stribeck) == EPF_STRIBECK_GAUSSIAN ? gaussian(q)
                                                             : lorentzian(q); /* (7), (8) */
}

/* |z_ss(v)|, eq. (9), for |v| > 0 */
/*@ requires valid_coeffs(c);
    requires 0 <= speed.zeros <= 31;
    assigns \nothing;
    ensures c->z_c <= \result <= c->z_max;
*/
static inline int32_t steady_state(const epf_fixed_coeffs_t *c, normal_t speed)
{
    return c->z_c + (int32_t)product((uint32_t)(c->z_max - c->z_c), stribeck_weight(c, speed));
}

/* All that follows from the velocity */
/*@ requires valid_coeffs(c) && \valid(point) && \separated(c, point);
    assigns *point;
    ensures valid_coeffs(c);
    ensures valid_point(c, point);
    ensures v > 0 ==> point->viscous >= 0;
    ensures v == 0 ==> point->viscous == 0 && point->z_ss == c->z_max;
    ensures v < 0 ==> point->viscous <= 0;
*/
static void prepare_point(const epf_fixed_coeffs_t *c, int32_t v, epf_fixed_point_t *point)
{
    int32_t z_ss = c->z_max;
    int32_t viscous = 0;
    if (v != 0) {
        const normal_t speed = normalised(magnitude(v));
        z_ss = steady_state(c, speed);
        viscous = along(v, (int32_t)gained(speed, c->viscous, 0));
    }
    const normal_t normal_z_ss = normalised((uint32_t)z_ss);
    const normal_t span = normalised((uint32_t)(z_ss - c->z_ba));
    volatile epf_fixed_point_t *target = point; /* written before publish_point() */
    target->z_ss = z_ss;
    target->viscous = viscous;
    target->inv_span = inverse(span.mantissa);
    target->span_share =
        quotient((uint32_t)(z_ss - c->z_ba), inverse(normal_z_ss.mantissa), normal_z_ss.zeros);
    target->span_zeros = (uint8_t)span.zeros;
}

/* ---- plasticity: eq. (10) ------------------------------------------------------------------ */

/* 1/2 + 1/2 sin(pi (u - 1/2)) for 0 <= u <= 1: the polynomial of f32.c */
/*@ assigns \nothing; */
static uint32_t half_sine(uint32_t u)
{
    const uint32_t mirror = u < 2147483648u ? 0 : ONE;
    const uint32_t x = u ^ mirror; /* u, or 1 - u */
    const uint32_t q = product(x, x);
    const uint32_t slope = 3373228340u - product(1386461432u - product(166200300u, q), q); /* Q31 */
    const uint32_t sine = 2u * product(slope, x);
    return product(sine, sine) ^ mirror;
}

/* How far zeta > z_ba is from z_ba to z_ss */
/*@ requires \valid_read(c) && \valid_read(point);
    requires 0 < c->z_ba < zeta < STATE_LIMIT;
    requires point->span_zeros <= 31;
    assigns \nothing;
*/
static uint32_t advance_in_span(const epf_fixed_coeffs_t *c, const epf_fixed_point_t *point,
                                int32_t zeta)
{
    return quotient((uint32_t)(zeta - c->z_ba), point->inv_span, point->span_zeros);
}

/* alpha zeta/z_ss for zeta > z_ba; with u the share of the span, zeta/z_ss = 1 - (1 - u) span/z_ss */
/*@ requires \valid_read(c) && \valid_read(point);
    requires 0 < c->z_ba < zeta < STATE_LIMIT;
    requires point->span_zeros <= 31;
    assigns \nothing;
*/
static uint32_t plastic_share(const epf_fixed_coeffs_t *c, const epf_fixed_point_t *point,
                              int32_t zeta)
{
    const uint32_t u = advance_in_span(c, point, zeta);
    return product(half_sine(u), ONE - product(ONE - u, point->span_share));
}

/* ---- the public functions ------------------------------------------------------------------ */

/* zeta' from above z_ba, where a part of the displacement is plastic */
/*@ requires valid_coeffs(c) && \valid_read(point) && valid_point(c, point);
    requires c->z_ba < zeta < point->z_ss;
    requires 0 < d;
    assigns \nothing;
    ensures zeta < \result <= point->z_ss && \result - zeta <= d;
*/
static int32_t slip(const epf_fixed_coeffs_t *c, const epf_fixed_point_t *point, int32_t zeta,
                    int32_t d)
{
    const uint32_t plastic = product((uint32_t)d, plastic_share(c, point, zeta));
    return psi(zeta, d, (int32_t)plastic, point->z_ss);
}

/* zeta' for so many counts of displacement, more than 0, in the direction in which z is zeta */
/*@ requires valid_coeffs(c) && \valid_read(point) && valid_point(c, point);
    requires -c->z_max <= zeta <= c->z_max;
    requires 0 < counts <= 2147483648;
    assigns \nothing;

    // Theorem 1: the state is bounded
    ensures -c->z_max <= \result <= point->z_ss;
    // Lemma 1: below z_ss the deflection changes by between nothing and the displacement, and
    // strictly: Theorem 2
    ensures zeta < point->z_ss ==> 0 < \result - zeta <= counts * c->unit;
    ensures zeta >= point->z_ss ==> \result == point->z_ss;
    // Lemma 2: plastic displacement has the direction of the motion, and needs more than z_ba
    ensures counts * c->unit - (\result - zeta) >= 0;
    ensures counts * c->unit - (\result - zeta) > 0 ==> \result > c->z_ba;
    // The elastic identity, to the unit: no drift
    ensures zeta + counts * c->unit <= c->z_ba ==>
              \result == zeta + counts * c->unit;
    // Theorem 2: a displacement of 2 z_max arrives at once
    ensures counts * c->unit >= 2 * c->z_max ==> \result == point->z_ss;
*/
static inline int32_t next_along(const epf_fixed_coeffs_t *c, const epf_fixed_point_t *point,
                                 int32_t zeta, uint32_t counts)
{
    /*@ assert counts < c->leap ==> counts * c->unit <= (c->leap - 1) * c->unit; */
    /*@ assert counts >= c->leap ==> counts * c->unit >= c->leap * c->unit; */
    if (zeta >= point->z_ss || counts >= c->leap) {
        return point->z_ss; /* case 1, or a displacement of 2 z_max */
    }
    const int32_t d = (int32_t)(counts * c->unit);
    /*@ assert d == counts * c->unit && 0 < d; */
    return zeta <= c->z_ba ? psi(zeta, d, 0, point->z_ss) : slip(c, point, zeta, d);
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
    if (dx == 0) {
        return stay(ep);
    }
    const epf_fixed_coeffs_t *c = ep->coeffs;
    const epf_fixed_point_t *point = published_point(ep);
    const int32_t zeta = next_along(c, point, along(dx, ep->z), magnitude(dx));
    return move_to(ep, dx > 0 ? 1 : -1, along(dx, zeta));
}

/*@ requires valid_body(ep);
    assigns ep->points[0 .. 1], ep->published;
    ensures valid_contact(ep);
*/
void epf_q31_set_velocity(epf_q31_t *ep, int32_t v)
{
    prepare_point(ep->coeffs, v, point_aside(ep));
    /*@ assert valid_motion(ep) && valid_coeffs(ep->coeffs); */
    publish_point(ep);
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
    if (dz == 0) {
        return 0;
    }
    const normal_t distance = normalised(magnitude(dz));
    const normal_t time = normalised(dt);
    const uint32_t p = product(distance.mantissa, 256u * c->damping.mantissa);
    return scaled(product(p, inverse(time.mantissa)),
                  c->damping.shift + 14 + distance.zeros - time.zeros);
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
    const uint64_t twice = p >> (c->output.shift - 1);
    const int32_t most = twice < UINT32_MAX ? (int32_t)(((uint32_t)twice + 1u) / 2u) : INT32_MAX;
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
    return *(const volatile int32_t *)&ep->z;
}

/*@ requires valid_coeffs(coeffs);
    assigns \nothing;
    ensures v > 0 ==> \result >= 0;
    ensures v == 0 ==> \result == 0;
    ensures v < 0 ==> \result <= 0;
*/
int32_t epf_q31_fss(const epf_q31_coeffs_t *coeffs, int32_t v)
{
    if (v == 0) {
        return 0;
    }
    const int32_t z_ss = steady_state(coeffs, normalised(magnitude(v)));
    return along(v, in_lsb(coeffs, z_ss, 0));
}

/*@ requires valid_coeffs(coeffs);
    assigns \nothing;
    ensures 0 <= \result <= STATE_LIMIT; // 0 to 1 in Q30
*/
int32_t epf_q31_alpha(const epf_q31_coeffs_t *coeffs, int32_t z, int32_t v)
{
    epf_fixed_point_t point;
    prepare_point(coeffs, v, &point);
    const int32_t zeta = along(v, clamped_state(coeffs, z));
    if (v == 0 || zeta <= coeffs->z_ba) {
        return 0;
    }
    return zeta < point.z_ss ? (int32_t)(half_sine(advance_in_span(coeffs, &point, zeta)) / 4u)
                             : STATE_LIMIT;
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
