/* SPDX-License-Identifier: MIT */
/*
 * The arithmetic of the estimator on 32-bit signals; contact.h has the estimator. Fractions are Q32
 * where nothing else is said, so that a product is the high word of a multiplication.
 */
#include "epf/q31.h"

#include "guard.h"
#include "numbers.h"
#include "only.h"

typedef int32_t signal_t;
typedef uint32_t duration_t;
typedef uint32_t fraction_t;
typedef epf_q31_coeffs_t coeffs_t;
typedef epf_q31_point_t point_t;
typedef epf_q31_t contact_t;
#define EPF(name)  epf_q31_##name
#define SIGNAL_MAX 2147483647
#define ONE        UINT32_MAX /* 1 is stored as the largest fraction, so y > 0 always */

/*@ predicate valid_leap(coeffs_t *c) =
      (c->leap - 1) * c->unit < 2 * c->z_max <= c->leap * c->unit;
    // Gains that keep their results in range, and an output that cannot lose the sign
    predicate valid_gains(coeffs_t *c) =
      c->ratio.mantissa < 2147483648 && c->ratio.up <= 31 &&
      c->viscous.mantissa < 536870912 && c->viscous.up <= 31 &&
      -31 <= c->damping_shift <= 0 &&
      c->output < 16777216 && 2 <= c->output_shift <= 63;
    // Leading zeros of a positive number
    predicate valid_span(point_t *p) = p->span_zeros <= 31;
*/
#include "valid.h"

#include "publish.h"

/* ---- products ------------------------------------------------------------------------------- */

#if defined(__ARM_ARCH_6M__) || defined(__ARM_ARCH_8M_BASE__)
#define HAS_NO_LONG_PRODUCT /* 32 by 32 to 64 bits: four products of 16 bits are faster */
#endif
#if defined(HAS_NO_LONG_PRODUCT) || defined(__AVR__)
#define PRODUCT_INLINE OUT_OF_LINE /* it is too long to stand in line */
#define INVERSE_INLINE OUT_OF_LINE
#else
#define PRODUCT_INLINE inline
#define INVERSE_INLINE inline
#endif

/* floor(a b) of two fractions */
/*@ assigns \nothing;
    ensures \result * 4294967296 <= a * b < (\result + 1) * 4294967296;
    ensures \result <= a && \result <= b;
    ensures 0 < a ==> \result < a; // strict progress
    ensures b == 0 ==> \result == 0;
*/
static PRODUCT_INLINE uint32_t product(uint32_t a, uint32_t b)
{
#ifdef HAS_NO_LONG_PRODUCT
    const uint32_t a_low = a % 65536u, a_high = a / 65536u;
    const uint32_t b_low = b % 65536u, b_high = b / 65536u;
    /*@ assert a_low * b_low <= 65535 * 65535 && a_high * b_low <= 65535 * 65535; */
    const uint32_t middle = a_high * b_low + a_low * b_low / 65536u;
    /*@ assert a_low * b_high <= 65535 * 65535 && a_high * b_high <= 65535 * 65535; */
    /*@ assert middle == a_high * b_low + (a_low * b_low) / 65536; */
    const uint32_t other = a_low * b_high + middle % 65536u;
    /*@ assert other == a_low * b_high + middle % 65536; */
    /*@ assert a * b == (a_high * b_high) * 4294967296 + (a_high * b_low + a_low * b_high) * 65536 +
                        a_low * b_low; */
    /*@ assert a * b == (a_high * b_high + middle / 65536 + other / 65536) * 4294967296 +
                        (other % 65536) * 65536 + (a_low * b_low) % 65536; */
    /*@ assert a * b <= a * 4294967295 && a * b <= 4294967295 * b; */
    return a_high * b_high + middle / 65536u + other / 65536u;
#else
    /*@ assert (integer)a * b <= a * 4294967295 && (integer)a * b <= 4294967295 * b; */
    return (uint32_t)((uint64_t)a * b / 4294967296u);
#endif
}

/* floor(x a), of an integer and a fraction */
/*@ assigns \nothing;
    ensures \result <= x && \result <= a;
    ensures 0 < x ==> \result < x; // strict progress
    ensures a == 0 ==> \result == 0;
*/
static inline uint32_t part(uint32_t x, uint32_t a)
{
    return product(x, a);
}

/* A fraction of 32 bits as a fraction_t, and the part that it is of an integer */
/*@ assigns \nothing;
    ensures \result == x;
*/
static inline uint32_t leading(uint32_t x)
{
    return x;
}

/*@ assigns \nothing; */
static inline uint32_t fine_part(uint32_t x, uint32_t a)
{
    return product(x, a);
}

/* a b, all of it */
/*@ assigns \nothing;
    ensures \result == a * b;
*/
static inline uint64_t wide(uint32_t a, uint32_t b)
{
    /*@ assert 0 <= (integer)a * b <= a * 4294967295; */
#ifdef HAS_NO_LONG_PRODUCT
    const uint32_t high = product(a, b), low = a * b;
    return (uint64_t)high * 4294967296u + low;
#else
    return (uint64_t)a * b;
#endif
}

/* ---- reciprocals ---------------------------------------------------------------------------- */

/*
 * 2^32/m in Q29, from below and so less than 2, for 2^31 <= m < 2^32. From a straight line within
 * 1/16 one step of third order, x (3 - t (3 - t)) with t = m x, and one of Newton's, x (2 - t).
 */
/*@ assigns \nothing; */
static INVERSE_INLINE uint32_t inverse(uint32_t m)
{
    uint32_t x = 3019898880u + m / 32u - m / 2u;
    const uint32_t t = product(m, x);
    x = 16u * product(x, 805306368u - product(t, 3221225472u - t));
    return product(x, 2u * ~product(m, x)); /* 2 - t in Q31, at least 2^-31 less */
}

/* d/(4 z), for d/4 < z < 2^30 */
/*@ requires 0 < z < 1073741824;
    assigns \nothing;
*/
static inline uint32_t quarter_of_ratio(uint32_t d, uint32_t z)
{
    const int zeros = leading_zeros(z);
    return 8u * product(d << (zeros - 2), inverse(z << zeros));
}

/* How far a time can be moved up, and 2^62 over what comes out */
/*@ requires 0 < dt;
    assigns \nothing;
    ensures 0 <= \result <= 31;
*/
static inline int zeros_of_time(uint32_t dt)
{
    return leading_zeros(dt);
}

/*@ requires 0 <= zeros <= 31;
    assigns \nothing;
*/
static inline uint32_t inverse_of_time(uint32_t dt, int zeros)
{
    return 2u * inverse(dt << zeros);
}

/* x g, for a gain that has a limit */
/*@ requires gain.up <= 31;
    assigns \nothing;
    ensures \result <= gain.mantissa;
*/
static inline uint32_t gained(uint32_t x, epf_q31_gain_t gain)
{
    return product((x < gain.limit ? x : gain.limit) << gain.up, gain.mantissa);
}

/*@ requires valid_coeffs(c);
    assigns \nothing;
    ensures \result <= TERM_MAX;
*/
static inline uint32_t viscous_term(const coeffs_t *c, uint32_t speed)
{
    return gained(speed, c->viscous);
}

/* ---- steady state: eqs. (6) to (8) ---------------------------------------------------------- */

/* 1/(1 + q), q in Q40 */
/*@ requires q < 4611686018427387904; // 2^62
    assigns \nothing;
*/
static inline uint32_t lorentzian(uint64_t q)
{
    const uint32_t x = (uint32_t)(q / 4294967296u) + 256u; /* 1 + q in Q8 ... */
    const int zeros = leading_zeros(x);
    const uint32_t mantissa =
        x << zeros | (uint32_t)q >> (32 - zeros); /* ... and what that cut off */
    return 8u * (inverse(mantissa) >> (24 - zeros));
}

/* exp(-q), q in Q40: 2^-n times 2^-r, 0 <= r < 1, by a polynomial that is exact at both ends */
/*@ assigns \nothing; */
static inline uint32_t gaussian(uint64_t q)
{
    if (q >= (uint64_t)22 << 40) {
        return 0;
    }
    const uint32_t t = product((uint32_t)(q >> 13), 3098164009u); /* log2 e in Q31; t in Q26 */
    const uint32_t n = t >> 26 & 31u;
    const uint32_t r = t << 6;
    /* 0.19314418 - r (0.04703982 - r (0.00826757 - r 0.00094842)) */
    const uint32_t bend =
        829547955u - product(r, 202034500u - product(r, 35508957u - product(r, 4073451u)));
    return (ONE - r / 2u - product(product(r, ONE - r), bend)) >> n;
}

/*@ requires valid_coeffs(c);
    assigns \nothing;
*/
static inline uint32_t stribeck_weight(const coeffs_t *c, uint32_t speed)
{
    const uint32_t ratio = gained(speed, c->ratio); /* |v|/v_s in Q20, below 2^31 */
    const uint64_t q = wide(ratio, ratio);
    /*@ assert q <= ratio * 2147483647 <= 2147483647 * 2147483647; */
    const epf_stribeck_t form = form_in_use(c->stribeck);
    if (form == EPF_STRIBECK_COULOMB) {
        return 0; /* (6) */
    }
    return form == EPF_STRIBECK_GAUSSIAN ? gaussian(q) : lorentzian(q); /* (7), (8) */
}

/* ---- the operating point -------------------------------------------------------------------- */

/* What the update needs of the span z_ss - z_ba: its reciprocal and span/z_ss, by one reciprocal of
   span z_ss */
/*@ requires valid_coeffs(c) && c->z_c <= z_ss <= c->z_max;
    requires -TERM_MAX <= viscous <= TERM_MAX;
    requires \valid(point) && \separated(c, point);
    assigns *point;
    ensures point->z_ss == z_ss && point->viscous == viscous && valid_span(point);
    ensures valid_coeffs(c) && valid_point(c, point);
*/
static LEAF void prepare(const coeffs_t *c, int32_t z_ss, int32_t viscous, point_t *point)
{
    const int span_zeros = leading_zeros((uint32_t)(z_ss - c->z_ba));
    const int whole_zeros = leading_zeros((uint32_t)z_ss);
    volatile point_t *target = point; /* written before it is published */
    target->z_ss = z_ss;
    target->viscous = viscous;
    target->span_zeros = (uint8_t)span_zeros;

    const uint32_t span = (uint32_t)(z_ss - c->z_ba) << span_zeros;
    const uint32_t whole = (uint32_t)z_ss << whole_zeros;
    const uint32_t both = product(span, whole);
    const int up = both < 2147483648u; /* it has 31 or 32 bits */
    const uint32_t inverse_of_both = 2u * inverse(both << up);
    const uint32_t inverse_of_whole = product(span, inverse_of_both) << up;
    const uint32_t share = product(span, inverse_of_whole); /* in Q30, but for the zeros */
    target->span_inverse = product(whole, inverse_of_both) << up;
    target->span_share = share >> (uint32_t)(span_zeros - whole_zeros) % 32u << 2;
}

/* ---- plasticity: eq. (10) ------------------------------------------------------------------- */

/* A gap z_ss - zeta as a share of the span, which is more */
/*@ requires \valid_read(point) && valid_span(point);
    assigns \nothing;
*/
static inline uint32_t share_of_span(const point_t *point, uint32_t gap)
{
    return 4u * product(gap << point->span_zeros, point->span_inverse);
}

/* 1/2 + 1/2 sin(pi (u - 1/2)) for 0 <= u <= 1: the polynomial of f32.c */
/*@ assigns \nothing; */
static inline uint32_t half_sine(uint32_t u)
{
    const uint32_t mirror = u < 2147483648u ? 0 : ONE;
    const uint32_t x = u ^ mirror; /* u, or 1 - u */
    const uint32_t q = product(x, x);
    const uint32_t slope = 3373228340u - product(1386461432u - product(166200300u, q), q); /* Q31 */
    const uint32_t sine = 2u * product(slope, x);
    return product(sine, sine) ^ mirror;
}

/*@ assigns \nothing;
    ensures 0 <= \result < STATE_LIMIT;
*/
static inline int32_t in_q30(uint32_t fraction)
{
    return (int32_t)(fraction / 4u);
}

/* ---- the force: eq. (14) -------------------------------------------------------------------- */

/* p 2^-shift for p = 2^32 high + low, at most UINT32_MAX - 1, to which 1 can be added; 1 <= shift */
/*@ requires 1 <= shift <= 63;
    assigns \nothing;
*/
static inline uint32_t shifted_down_64(uint32_t high, uint32_t low, int shift)
{
    if (shift >= 32) { /* high is below 2^32 - 1 */
        return shifted_down(high, shift - 32);
    }
    const uint32_t x = high << (32 - shift) | low >> shift;
    return high >> shift == 0 && x != UINT32_MAX ? x : UINT32_MAX - 1u;
}

/* sigma_0 z + 256 terms, in sigma_0 u, in lsb.f, to the nearest, saturating */
/*@ requires valid_coeffs(c);
    requires -STATE_LIMIT < z < STATE_LIMIT && -2 * TERM_MAX <= terms <= 2 * TERM_MAX;
    assigns \nothing;
    ensures -2147483647 <= \result <= 2147483647;
    // Theorem 3 on the output: it never has the other sign
    ensures z + 256 * terms > 0 ==> \result >= 0;
    ensures z + 256 * terms < 0 ==> \result <= 0;
*/
static LEAF int32_t in_lsb(const coeffs_t *c, int32_t z, int32_t terms)
{
    const int64_t force = (int64_t)z + 256 * (int64_t)terms;
    const uint64_t size = (uint64_t)(force < 0 ? -force : force); /* below 2^39 */
    const uint32_t low = (uint32_t)size, high = (uint32_t)(size >> 32);
    const uint32_t twice = shifted_down_64(product(low, c->output) + high * c->output,
                                           low * c->output, c->output_shift - 1);
    const int32_t most = (int32_t)((twice + 1u) / 2u);
    return force < 0 ? -most : most;
}

#include "contact.h"
