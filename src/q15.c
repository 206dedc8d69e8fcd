/* SPDX-License-Identifier: MIT */
/*
 * The estimator on 16-bit signals, with products of 16 by 16 bits and no division: for cores that
 * have no more. Read next_along() for the update rule and epf_q15_force() for eq. (14). Fractions
 * are Q16, 2^16 is 1, where nothing else is said; the state keeps its 32 bits.
 */
#include "epf/q15.h"

#include "kernel.h"

/* The fraction next to 1 stands for 1: no part of a displacement is ever all of it */
#define ONE UINT16_MAX

/*@ // The largest force fits 16 bits: as epf_q15_coeffs_init makes them
    predicate short_output(epf_fixed_coeffs_t *c) = 33 <= c->output.shift;

    predicate valid_short_contact(epf_fixed_t *ep) = valid_contact(ep) && short_output(ep->coeffs);
*/

/* AVR's compiler multiplies 32 by 32 bits wherever it sees that the factors were longer once */
#ifdef __AVR__
#define FORGET_ORIGIN(x) __asm__("" : "+r"(x))
#else
#define FORGET_ORIGIN(x) (void)(x)
#endif

/* a b */
/*@ assigns \nothing;
    ensures \result == a * b;
    ensures \result <= a * 65535 && \result <= 65535 * b;
*/
static uint32_t wide(uint16_t a, uint16_t b)
{
    FORGET_ORIGIN(a);
    FORGET_ORIGIN(b);
    return (uint32_t)a * b;
}

/* The 16 highest bits */
/*@ assigns \nothing;
    ensures \result == x / 65536;
*/
static uint16_t high(uint32_t x)
{
    return (uint16_t)(x / 65536u);
}

/* floor(a b) */
/*@ assigns \nothing;
    ensures \result <= a && \result <= b;
    ensures 0 < a ==> \result < a;
*/
static uint16_t product(uint16_t a, uint16_t b)
{
    return high(wide(a, b));
}

/* floor(a b), of an integer and a fraction: two products of 16 bits do for 48 */
/*@ assigns \nothing;
    ensures b == 0 ==> \result == 0;
    ensures \result <= a;
    ensures 0 < a ==> \result < a; // strict progress
*/
static uint32_t part(uint32_t a, uint16_t b)
{
    return wide(high(a), b) + product((uint16_t)(a % 65536u), b);
}

/*
 * About 2^31/m, and less, for 2^15 <= m < 2^16, without a division, which small cores do not have:
 * two steps of Newton's iteration, x (2 - m x/2^31), from a straight line within 1/17.
 */
/*@ requires 32768 <= m;
    assigns \nothing;
*/
static uint16_t reciprocal(uint16_t m)
{
    uint16_t x = (uint16_t)(92517u - product(m, 61681u));
    x = high(2u * wide(x, high(0u - wide(m, x))));
    return high(2u * wide(x, high(0u - wide(m, x))));
}

/* The 16 highest bits of a gain's mantissa; its shift is then 8 less */
/*@ requires gain.mantissa < 16777216;
    assigns \nothing;
*/
static uint16_t mantissa_16(epf_gain_t gain)
{
    return (uint16_t)(gain.mantissa / 256u);
}

/* 2^power x times a gain, at most TERM_MAX */
/*@ requires gain.mantissa < 16777216;
    requires 0 <= x.zeros <= 31 && 0 <= power <= 32;
    assigns \nothing;
    ensures \result <= TERM_MAX;
*/
static uint32_t gained(normal_t x, epf_gain_t gain, int power)
{
    return scaled(wide(high(x.mantissa), mantissa_16(gain)), gain.shift + x.zeros - 24 - power);
}

/* 2^32/x; less than 1 counts as 1 */
/*@ assigns \nothing; */
static uint32_t inverse(uint16_t x)
{
    const normal_t m = normalised(x != 0 ? x : 1u);
    return shifted_down(reciprocal(high(m.mantissa)) * UINT32_C(65536), 31 - m.zeros);
}

/* a/x for 0 <= a <= x, from the inverse of x, which is less than 2^32/x: so this is less than 1 */
/*@ assigns \nothing; */
static uint16_t quotient(uint16_t a, uint32_t inverse_of_x)
{
    return (uint16_t)part(inverse_of_x, a);
}

/* A length below 2^30 in 16 bits, for inverse() and quotient() */
/*@ requires 0 < x < STATE_LIMIT;
    assigns \nothing;
*/
static uint16_t coarse(int32_t x)
{
    return (uint16_t)((uint32_t)x / 16384u);
}

/* ---- steady state: eqs. (6) to (9) --------------------------------------------------------- */

/* 1/(1 + q), q in Q20, below 2^32 - 2^20 */
/*@ requires q < 4293918720;
    assigns \nothing;
*/
static uint16_t lorentzian(uint32_t q)
{
    const normal_t x = normalised(1048576u + q);
    return (uint16_t)(reciprocal(high(x.mantissa)) >> (11 - x.zeros));
}

/* exp(-q), q in Q20. As in f32.c: 2^-n times 2^-r, 0 <= r < 1 */
/*@ assigns \nothing; */
static uint16_t gaussian(uint32_t q)
{
    if (q >= UINT32_C(11) << 20) {
        return 0;
    }
    const uint32_t t = wide((uint16_t)(q / 256u), 5909u); /* log2 e in Q12; now Q24 */
    const uint8_t n = (uint8_t)(t / 16777216u);
    const uint16_t r = (uint16_t)(t / 256u);
    const uint16_t bend = (uint16_t)(12562u - product(r, 2597u)); /* 0.19167742 - 0.03962246 r */
    const uint16_t power =
        (uint16_t)(ONE - r / 2u - product(product(r, (uint16_t)(ONE - r)), bend));
    return (uint16_t)(power >> n);
}

/*@ requires valid_coeffs(c);
    requires 0 <= speed.zeros <= 31;
    assigns \nothing;
*/
static uint16_t stribeck_weight(const epf_fixed_coeffs_t *c, normal_t speed)
{
    const uint32_t ratio = gained(speed, c->v_s_inverse, 10); /* Q10; 60 v_s and more are as one */
    const uint16_t r = (uint16_t)(ratio < 61440u ? ratio : 61440u);
    const uint32_t q = wide(r, r);
    /*@ assert q <= 61440 * 61440; */
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
static int32_t steady_state(const epf_fixed_coeffs_t *c, normal_t speed)
{
    return c->z_c + (int32_t)part((uint32_t)(c->z_max - c->z_c), stribeck_weight(c, speed));
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
static void prepare_point(const epf_fixed_coeffs_t *c, int16_t v, epf_fixed_point_t *point)
{
    int32_t z_ss = c->z_max;
    int32_t viscous = 0;
    if (v != 0) {
        const normal_t speed = normalised(magnitude(v));
        z_ss = steady_state(c, speed);
        viscous = along(v, (int32_t)gained(speed, c->viscous, 0));
    }
    const uint16_t span = coarse(z_ss - c->z_ba);
    volatile epf_fixed_point_t *target = point; /* written before publish_point() */
    target->z_ss = z_ss;
    target->viscous = viscous;
    target->inv_span = inverse(span);
    target->span_share = quotient(span, inverse(coarse(z_ss)));
    target->span_zeros = 0;
}

/* ---- plasticity: eq. (10) ------------------------------------------------------------------ */

/* 1/2 + 1/2 sin(pi (u - 1/2)) for 0 <= u <= 1, within 3e-4, and never falling: as in f32.c with one
   term less, 1.5684085 - 0.6167798 x^2 */
/*@ assigns \nothing; */
static uint16_t half_sine(uint16_t u)
{
    const uint16_t mirror = u < 32768u ? 0 : ONE;
    const uint16_t x = u ^ mirror;                                              /* u, or 1 - u */
    const uint16_t slope = (uint16_t)(51394u - product(product(x, x), 20211u)); /* Q15 */
    const uint16_t sine = high(2u * wide(slope, x));
    return product(sine, sine) ^ mirror;
}

/* How far zeta > z_ba is from z_ba to z_ss */
/*@ requires \valid_read(c) && \valid_read(point);
    requires 0 < c->z_ba < zeta < STATE_LIMIT;
    assigns \nothing;
*/
static uint16_t advance_in_span(const epf_fixed_coeffs_t *c, const epf_fixed_point_t *point,
                                int32_t zeta)
{
    return quotient(coarse(zeta - c->z_ba), point->inv_span);
}

/* alpha zeta/z_ss for zeta > z_ba; with u the share of the span, zeta/z_ss = 1 - (1 - u) span/z_ss */
/*@ requires \valid_read(c) && \valid_read(point);
    requires 0 < c->z_ba < zeta < STATE_LIMIT;
    assigns \nothing;
*/
static uint16_t plastic_share(const epf_fixed_coeffs_t *c, const epf_fixed_point_t *point,
                              int32_t zeta)
{
    const uint16_t u = advance_in_span(c, point, zeta);
    const uint16_t short_of = product((uint16_t)(ONE - u), (uint16_t)point->span_share);
    return product(half_sine(u), (uint16_t)(ONE - short_of));
}

/* ---- the public functions ------------------------------------------------------------------ */

/* zeta' from above z_ba, where a part of the displacement is plastic */
/*@ requires valid_coeffs(c) && \valid_read(point) && valid_point(c, point);
    requires c->z_ba < zeta < point->z_ss;
    requires 0 < d;
    assigns \nothing;
    ensures zeta < \result <= point->z_ss && \result - zeta <= d;
*/
static OUT_OF_LINE int32_t slip(const epf_fixed_coeffs_t *c, const epf_fixed_point_t *point,
                                int32_t zeta, int32_t d)
{
    const uint32_t plastic = part((uint32_t)d, plastic_share(c, point, zeta));
    return psi(zeta, d, (int32_t)plastic, point->z_ss);
}

/* zeta' for so many counts of displacement, more than 0, in the direction in which z is zeta */
/*@ requires valid_coeffs(c) && \valid_read(point) && valid_point(c, point);
    requires -c->z_max <= zeta <= c->z_max;
    requires 0 < counts <= 32768;
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

/*@ requires valid_short_contact(ep);
    assigns ep->z, ep->dz, ep->direction;
    // Theorem 1: the state is bounded, by every operating point
    ensures valid_short_contact(ep);
    ensures \result == ep->z;
    ensures dx == 0 ==> ep->z == \old(ep->z);
*/
int32_t epf_q15_advance(epf_q15_t *ep, int16_t dx)
{
    if (dx == 0) {
        return stay(ep);
    }
    const epf_fixed_coeffs_t *c = ep->coeffs;
    const epf_fixed_point_t *point = published_point(ep);
    return dx > 0 ? move_to(ep, 1, next_along(c, point, ep->z, magnitude(dx)))
                  : move_to(ep, -1, -next_along(c, point, -ep->z, magnitude(dx)));
}

/*@ requires valid_body(ep) && short_output(ep->coeffs);
    assigns ep->points[0 .. 1], ep->published;
    ensures valid_short_contact(ep);
*/
void epf_q15_set_velocity(epf_q15_t *ep, int16_t v)
{
    prepare_point(ep->coeffs, v, point_aside(ep));
    /*@ assert valid_motion(ep) && valid_coeffs(ep->coeffs); */
    publish_point(ep);
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
    if (dz == 0) {
        return 0;
    }
    const normal_t distance = normalised(magnitude(dz));
    const normal_t time = normalised(dt);
    const uint16_t p = product(high(distance.mantissa), mantissa_16(c->damping));
    return scaled(wide(p, reciprocal(high(time.mantissa))),
                  c->damping.shift + 15 + distance.zeros - time.zeros);
}

/* sigma_0 z + 2^8 rest in lsb.f, to the nearest, saturating */
/*@ requires valid_coeffs(c) && short_output(c);
    requires -STATE_LIMIT < z < STATE_LIMIT && -2 * TERM_MAX <= rest <= 2 * TERM_MAX;
    assigns \nothing;
    ensures -32767 <= \result <= 32767;
*/
static int16_t in_lsb(const epf_fixed_coeffs_t *c, int32_t z, int32_t rest)
{
    const int32_t force = along(z, (int32_t)(magnitude(z) / 256u)) + rest;
    const uint32_t p = part(magnitude(force), mantissa_16(c->output));
    const int shift = c->output.shift - 32; /* 1 at the least, since f_max fits */
    const uint32_t rounded = (shifted_down(p, shift - 1) + 1u) / 2u;
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
    return *(const volatile int32_t *)&ep->z;
}

/*@ requires valid_coeffs(coeffs) && short_output(coeffs);
    assigns \nothing;
*/
int16_t epf_q15_fss(const epf_q15_coeffs_t *coeffs, int16_t v)
{
    if (v == 0) {
        return 0;
    }
    const int32_t z_ss = steady_state(coeffs, normalised(magnitude(v)));
    return (int16_t)along(v, in_lsb(coeffs, z_ss, 0));
}

/*@ requires valid_coeffs(coeffs);
    assigns \nothing;
    ensures 0 <= \result <= STATE_LIMIT; // 0 to 1 in Q30
*/
int32_t epf_q15_alpha(const epf_q15_coeffs_t *coeffs, int32_t z, int16_t v)
{
    epf_fixed_point_t point;
    prepare_point(coeffs, v, &point);
    const int32_t zeta = along(v, clamped_state(coeffs, z));
    if (v == 0 || zeta <= coeffs->z_ba) {
        return 0;
    }
    return zeta < point.z_ss ? INT32_C(16384) * half_sine(advance_in_span(coeffs, &point, zeta))
                             : STATE_LIMIT;
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
