/* SPDX-License-Identifier: MIT */
/*
 * The arithmetic of the estimator on 16-bit signals, with products of 16 by 16 bits and no division:
 * for cores that have no more. contact.h has the estimator. Fractions are Q16, 2^16 is 1, where nothing
 * else is said; the state keeps its 32 bits.
 */
#include "epf/q15.h"

#include "guard.h"
#include "numbers.h"
#include "only.h"

typedef int16_t signal_t;
typedef uint16_t duration_t;
typedef uint16_t fraction_t;
typedef epf_q15_coeffs_t coeffs_t;
typedef epf_q15_point_t point_t;
typedef epf_q15_t contact_t;
#define EPF(name)  epf_q15_##name
#define SIGNAL_MAX 32767
#define ONE        UINT16_MAX /* 1 is stored as the largest fraction, so y > 0 always */

/*@ // A leap that no displacement reaches need not fit
    predicate valid_leap(coeffs_t *c) =
      (c->leap - 1) * c->unit < 2 * c->z_max &&
      (2 * c->z_max <= c->leap * c->unit || c->leap == 65535);
    // Gains that keep their results in range
    predicate valid_gains(coeffs_t *c) =
      c->ratio_limit * c->ratio < 61440 * 65536 && 3 <= c->viscous_shift <= 31 &&
      -31 <= c->damping_shift <= 1 && 1 <= c->output_shift <= 31;
    predicate valid_span(point_t *p) = p->span_shift <= 14;
*/
#include "valid.h"

#include "publish.h"

/* ---- products ------------------------------------------------------------------------------- */

/* avr-gcc multiplies 32 by 32 bits when it sees the truncation; this hides it */
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
static inline uint32_t wide(uint16_t a, uint16_t b)
{
    FORGET_ORIGIN(a);
    FORGET_ORIGIN(b);
    return (uint32_t)a * b;
}

/* The 16 highest bits */
/*@ assigns \nothing;
    ensures \result == x / 65536;
*/
static inline uint16_t high(uint32_t x)
{
    return (uint16_t)(x / 65536u);
}

/* floor(a b) of two fractions */
/*@ assigns \nothing;
    ensures \result <= a && \result <= b;
    ensures 0 < a ==> \result < a;
*/
static inline uint16_t product(uint16_t a, uint16_t b)
{
    return high(wide(a, b));
}

/* floor(x a) of an integer and a fraction: two products of 16 bits do for 48 */
/*@ assigns \nothing;
    ensures a == 0 ==> \result == 0;
    ensures \result <= x;
    ensures 0 < x ==> \result < x; // strict progress
*/
static inline uint32_t part(uint32_t x, uint16_t a)
{
    return wide(high(x), a) + product((uint16_t)(x % 65536u), a);
}

/* The leading bits of a fraction of 32 bits, and the part that it is of an integer */
/*@ assigns \nothing; */
static inline uint16_t leading(uint32_t x)
{
    return high(x);
}

/*@ assigns \nothing; */
static inline uint32_t fine_part(uint32_t x, uint32_t a)
{
    return part(x, high(a)) + high(part(x, (uint16_t)(a % 65536u)));
}

/* ---- reciprocals ---------------------------------------------------------------------------- */

/*
 * About 2^31/m, and less, for 2^15 <= m < 2^16: two steps of Newton's iteration, x (2 - m x/2^31), from a
 * straight line within 1/16.
 */
/*@ assigns \nothing; */
static OUT_OF_LINE uint16_t inverse(uint16_t m)
{
    uint16_t x = (uint16_t)(92400u - (m - m / 16u));
    x = high(2u * wide(x, high(0u - wide(m, x))));
    return high(2u * wide(x, high(0u - wide(m, x))));
}

/* d/(4 z) in Q32, for d/4 < z < 2^30 */
/*@ requires 0 < z < 1073741824;
    assigns \nothing;
*/
static inline uint32_t quarter_of_ratio(uint32_t d, uint32_t z)
{
    const int zeros = leading_zeros(z);
    return 2u * part(d << (zeros - 2), inverse(high(z << zeros)));
}

/* How far a time can be moved up, and 2^31 over the 16 bits that come out */
/*@ requires 0 < dt;
    assigns \nothing;
    ensures 0 <= \result <= 15;
*/
static inline int zeros_of_time(uint16_t dt)
{
    return leading_zeros_16((uint32_t)dt * 65536u);
}

/*@ requires 0 <= zeros <= 15;
    assigns \nothing;
*/
static inline uint16_t inverse_of_time(uint16_t dt, int zeros)
{
    return inverse((uint16_t)((unsigned)dt << zeros));
}

/* sigma_2 |v|, by a gain that has a limit */
/*@ requires valid_coeffs(c);
    assigns \nothing;
    ensures \result <= TERM_MAX;
*/
static inline uint32_t viscous_term(const coeffs_t *c, uint32_t speed)
{
    const uint32_t limited = speed < c->viscous_limit ? speed : c->viscous_limit;
    const uint32_t term = shifted_down(limited * c->viscous, c->viscous_shift);
    return term < TERM_MAX ? term : TERM_MAX; /* by its limit it is; this tells the provers */
}

/* ---- steady state: eqs. (6) to (8) ---------------------------------------------------------- */

/* 1/(1 + q), q in Q20, below 2^32 - 2^20 */
/*@ requires q < 4293918720;
    assigns \nothing;
*/
static inline uint16_t lorentzian(uint32_t q)
{
    const uint32_t x = 1048576u + q;
    const int zeros = leading_zeros_16(x);
    return (uint16_t)(inverse(high(x << zeros)) >> (11 - zeros));
}

/* exp(-q), q in Q20. As in f32.c: 2^-n times 2^-r, 0 <= r < 1 */
/*@ assigns \nothing; */
static inline uint16_t gaussian(uint32_t q)
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
    assigns \nothing;
*/
static inline uint16_t stribeck_weight(const coeffs_t *c, uint32_t speed)
{
    const uint32_t limited = speed < c->ratio_limit ? speed : c->ratio_limit;
    /*@ assert limited * c->ratio <= c->ratio_limit * c->ratio; */
    const uint16_t ratio = high(limited * c->ratio + 32768u); /* |v|/v_s in Q10, up to 60 */
    /*@ assert ratio <= 61440; */
    const uint32_t q = wide(ratio, ratio);
    /*@ assert q <= ratio * 61440 <= 61440 * 61440; */
    const epf_stribeck_t form = form_in_use(c->stribeck);
    if (form == EPF_STRIBECK_COULOMB) {
        return 0; /* (6) */
    }
    return form == EPF_STRIBECK_GAUSSIAN ? gaussian(q) : lorentzian(q); /* (7), (8) */
}

/* ---- the operating point -------------------------------------------------------------------- */

/* What the update needs of the span z_ss - z_ba: its reciprocal and span/z_ss, by one reciprocal of
   span z_ss. 16 bits of z_ss are enough, but a short span must not lose its leading ones. */
/*@ requires valid_coeffs(c) && c->z_c <= z_ss <= c->z_max;
    requires -TERM_MAX <= viscous <= TERM_MAX;
    requires \valid(point) && \separated(c, point);
    assigns *point;
    ensures point->z_ss == z_ss && point->viscous == viscous && valid_span(point);
    ensures valid_coeffs(c) && valid_point(c, point);
*/
static LEAF void prepare(const coeffs_t *c, int32_t z_ss, int32_t viscous, point_t *point)
{
    const uint32_t exact_span = (uint32_t)(z_ss - c->z_ba);
    const int span_shift = exact_span < 67108864u ? 10 : 14; /* 2^26 */
    volatile point_t *target = point;                        /* written before it is published */
    target->z_ss = z_ss;
    target->viscous = viscous;
    target->span_shift = (uint8_t)span_shift;

    const uint16_t span = (uint16_t)shifted_down(exact_span, span_shift);
    const uint16_t whole = (uint16_t)((uint32_t)z_ss >> 14);
    const uint32_t product_of_both = wide(span, whole);
    const uint32_t both = product_of_both > 65536u ? product_of_both : 65536u;
    const int zeros = leading_zeros_16(both);
    /* 2^(47 - zeros)/both; 2 less, because it is made of 16 bits of it, and must not be too large */
    const uint16_t inverse_of_both = (uint16_t)(inverse(high(both << zeros)) - 2u);
    target->span_inverse = shifted_down(wide(whole, inverse_of_both), 15 - zeros);
    const uint32_t share =
        shifted_down(part(wide(span, span), inverse_of_both), 29 - span_shift - zeros);
    target->span_share = (uint16_t)(share < ONE ? share : ONE); /* where z_ss lost too many bits */
}

/* ---- plasticity: eq. (10) ------------------------------------------------------------------- */

/* A gap z_ss - zeta as a share of the span, which is more */
/*@ requires \valid_read(point) && valid_span(point);
    assigns \nothing;
*/
static inline uint16_t share_of_span(const point_t *point, uint32_t gap)
{
    return (uint16_t)part(point->span_inverse, (uint16_t)shifted_down(gap, point->span_shift));
}

/* 1/2 + 1/2 sin(pi (u - 1/2)) for 0 <= u <= 1, within 3e-4, and never falling: as in f32.c with one
   term less, 1.5684085 - 0.6167798 x^2 */
/*@ assigns \nothing; */
static inline uint16_t half_sine(uint16_t u)
{
    const uint16_t mirror = u < 32768u ? 0 : ONE;
    const uint16_t x = u ^ mirror;                                              /* u, or 1 - u */
    const uint16_t slope = (uint16_t)(51394u - product(product(x, x), 20211u)); /* Q15 */
    const uint16_t sine = high(2u * wide(slope, x));
    return product(sine, sine) ^ mirror;
}

/*@ assigns \nothing;
    ensures 0 <= \result < STATE_LIMIT;
*/
static inline int32_t in_q30(uint16_t fraction)
{
    return INT32_C(16384) * fraction;
}

/* ---- the force: eq. (14) -------------------------------------------------------------------- */

/* sigma_0 z, cut to 256 sigma_0 u, and the other terms in lsb.f, to the nearest, saturating */
/*@ requires valid_coeffs(c);
    requires -STATE_LIMIT < z < STATE_LIMIT && -2 * TERM_MAX <= terms <= 2 * TERM_MAX;
    assigns \nothing;
    ensures -32767 <= \result <= 32767;
    // Theorem 3 on the output: it never has the other sign
    ensures z + 256 * terms > 0 ==> \result >= 0;
    ensures z + 256 * terms < 0 ==> \result <= 0;
*/
static inline int16_t in_lsb(const coeffs_t *c, int32_t z, int32_t terms)
{
    const int32_t elastic = (int32_t)(magnitude(z) / 256u);
    const int32_t force = (z < 0 ? -elastic : elastic) + terms;
    /*@ assert z + 256 * terms - 255 <= 256 * force <= z + 256 * terms + 255; */
    const uint32_t p = part(magnitude(force), c->output);
    const uint32_t rounded = (shifted_down(p, c->output_shift) + 1u) / 2u;
    const int16_t most = (int16_t)(rounded < INT16_MAX ? rounded : INT16_MAX);
    return (int16_t)(force < 0 ? -most : most);
}

#include "contact.h"
