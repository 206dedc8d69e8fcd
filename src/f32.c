/* SPDX-License-Identifier: MIT */
/* The estimator in single precision. Read move() for the update rule, resist() for eq. (14). Unusable
   and overflowing inputs leave the common path by one comparison each. */
#include "epf/f32.h"

#include "stribeck.h"

#include <stddef.h>

#if FLT_RADIX != 2 || FLT_MANT_DIG != 24 || FLT_MAX_EXP != 128
#error "epf/f32 needs float to be IEEE 754 binary32"
#endif
#if FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 16 /* 16: only half precision is widened */
#error "epf/f32 needs float expressions to be evaluated in float (on 32-bit x86: -mfpmath=sse)"
#endif
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "epf/f32 needs IEEE arithmetic: compile this file without -ffast-math and its parts"
#endif
#ifdef __clang__
#pragma STDC FP_CONTRACT OFF /* gcc: -ffp-contract=off, or -std=c99 */
#endif

#define TERM_MAX (FLT_MAX / 4.0f) /* three terms of the force cannot overflow */

static float at_most(float x, float bound)
{
    return x < bound ? x : bound;
}

/* x in [-bound, bound]; x is not NaN */
static float within(float x, float bound)
{
    return x > bound ? bound : x < -bound ? -bound : x;
}

static int is_nan(float x)
{
    return x != x;
}

/* x - x is 0 for a number, and NaN for infinity and NaN */
static int is_finite(float x)
{
    return x - x == 0.0f;
}

static int is_positive_and_finite(float x)
{
    return x > x - x;
}

static void reject(epf_f32_t *ep)
{
    if (ep->rejected != UINT32_MAX) { /* never decreasing: it saturates instead of wrapping */
        ep->rejected++;
    }
}

/* ---- steady state: eqs. (6) to (9) ---------------------------------------------------------- */

/* exp(-q) for q >= 0, within 3e-7: 2^-n by its bit pattern, times 2^-r, 0 <= r < 1, by a polynomial
   that is exact at both ends, so that the pieces join */
static inline float exp_minus(float q)
{
    const float t = q * 1.44269504f; /* log2 e */
    if (!(t < 126.0f)) {
        return is_nan(t) ? t : 0.0f;
    }
    const uint32_t n = (uint32_t)t;
    const float r = t - (float)n;
    const union {
        uint32_t bits;
        float value;
    } power = {(127u - n) << 23};
    const float bend =
        -0.193144184f + r * (0.0470398227f + r * (-0.00826757329f + r * 0.000948424026f));
    return power.value * (1.0f - r * (0.5f - (1.0f - r) * bend));
}

/* What f_ss(v) or z_ss(v) has beyond f_c or z_c: at rest all of the excess. NaN stays NaN. */
static inline float stribeck(const epf_f32_coeffs_t *c, float excess, float v)
{
    const epf_stribeck_t form = form_in_use(c->stribeck);
    if (form == EPF_STRIBECK_COULOMB) {
        return is_nan(v) ? v : v == 0.0f ? excess : 0.0f; /* (6) */
    }
    const float ratio = v * c->inv_v_s;
    const float q = ratio * ratio;
    if (form == EPF_STRIBECK_GAUSSIAN) {
        return excess * exp_minus(q); /* (7) */
    }
    return excess / (1.0f + q); /* (8) */
}

/* |z_ss(v)|, eq. (9): never above z_max, for that is z_c + z_excess and rounding is monotonic */
static inline float steady_state(const epf_f32_coeffs_t *c, float v)
{
    return c->z_c + stribeck(c, c->z_excess, v);
}

float epf_f32_fss(const epf_f32_coeffs_t *coeffs, float v)
{
    const float excess = coeffs->f_max - coeffs->f_c;
    const float force = at_most(coeffs->f_c + stribeck(coeffs, excess, v), coeffs->f_max);
    return v > 0.0f ? force : v < 0.0f ? -force : 0.0f;
}

/* ---- the operating point: all that follows from the velocity -------------------------------- */

/* Both reciprocals by one division, in which a product that is 0 makes them infinite */
static inline epf_f32_point_t operating_point(const epf_f32_coeffs_t *c, float v)
{
    const float z_ss = steady_state(c, v);
    const float span = z_ss - c->z_ba;
    const float both = 1.0f / (z_ss * span);
    return (epf_f32_point_t){v, z_ss, both * span, both * z_ss};
}

/* Not where v is NaN, nor where z_ss (z_ss - z_ba) left the range of float */
static inline int is_usable(epf_f32_point_t point)
{
    return is_positive_and_finite(point.inv_span);
}

static const epf_f32_point_t *published_point(const epf_f32_t *ep)
{
    return &ep->points[*(const volatile uint8_t *)&ep->published];
}

/* Volatile accesses keep their order: the index follows the point that it announces */
static inline void publish_point(epf_f32_t *ep, epf_f32_point_t point)
{
    const uint8_t aside = ep->published ^ 1u;
    volatile epf_f32_point_t *target = &ep->points[aside];
    target->v = point.v;
    target->z_ss = point.z_ss;
    target->inv_z_ss = point.inv_z_ss;
    target->inv_span = point.inv_span;
    *(volatile uint8_t *)&ep->published = aside;
}

void epf_f32_set_velocity(epf_f32_t *ep, float v)
{
    if (is_nan(v)) {
        reject(ep);
        return;
    }
    const epf_f32_point_t point = operating_point(ep->coeffs, v);
    if (is_usable(point)) {
        publish_point(ep, point);
    } else {
        const float span = point.z_ss - ep->coeffs->z_ba;
        publish_point(ep, (epf_f32_point_t){v, point.z_ss, 1.0f / point.z_ss, 1.0f / span});
    }
}

/* ---- plasticity: eq. (10) ------------------------------------------------------------------- */

/* 1 - alpha between z_ba and z_ss, where u = (z_ss - zeta)/(z_ss - z_ba): the half period of a sine,
   which is its own mirror image, within 8e-7. Exact at both ends, level there, and never above 1. */
static inline float elastic_share(float u)
{
    const float m = u - u * u;
    return u + (u - 0.5f) * m * (2.0f + m * (1.06417607f + m * 0.273587248f));
}

float epf_f32_alpha(const epf_f32_coeffs_t *coeffs, float z, float v)
{
    const float zeta = v > 0.0f ? z : v < 0.0f ? -z : 0.0f;
    if (!(zeta > coeffs->z_ba)) {
        return 0.0f;
    }
    const float z_ss = steady_state(coeffs, v);
    const float gap = z_ss - zeta;
    return gap > 0.0f ? 1.0f - elastic_share(gap / (z_ss - coeffs->z_ba)) : 1.0f;
}

/* ---- the state: eqs. (12) and (13) ---------------------------------------------------------- */

/* The unevaluated sum high + low, |low| <= ulp(high)/2 */
typedef struct {
    float high, low;
} deflection_t;

/* z + y, exact to 48 bits (Knuth's two-sum); odd, and never less than z for y >= 0 */
static inline deflection_t add(deflection_t z, float y)
{
    const float sum = z.high + y;
    const float y_seen = sum - z.high;
    const float lost = (z.high - (sum - y_seen)) + (y - y_seen);
    const float low = z.low + lost;
    const float high = sum + low;
    return (deflection_t){high, low - (high - sum)};
}

/* 1 - alpha zeta/z_ss, eq. (12), from the gap z_ss - zeta > 0: relatively precise, so that the last
   of the gap closes too */
static inline float deflecting_share(const epf_f32_point_t *point, float gap)
{
    const float rest = gap * point->inv_z_ss; /* 1 - zeta/z_ss */
    return rest + elastic_share(gap * point->inv_span) * (1.0f - rest);
}

/* No displacement, or none that is known */
static float stay(epf_f32_t *ep, float dx)
{
    if (is_nan(dx)) {
        reject(ep);
    } else {
        ep->direction = 0;
        ep->dz = dx;
    }
    return ep->direction;
}

/* Returns sgn dx. In its direction the deflection is zeta = s z, and the gap z_ss - zeta; in case 1
   that is not positive. A y below the gap, both rounded, cannot carry the sum above z_ss. */
static inline float move(epf_f32_t *ep, const epf_f32_point_t *point, float dx)
{
    if (!(dx > 0.0f || dx < 0.0f)) {
        return stay(ep, dx);
    }
    const float s = dx > 0.0f ? 1.0f : -1.0f;
    const float zeta = s * ep->z;
    const float gap = (point->z_ss - zeta) - s * ep->z_low;

    float y = dx;
    if (zeta > ep->coeffs->z_ba && gap > 0.0f) {
        y = deflecting_share(point, gap) * dx; /* (12) */
    }
    ep->direction = dx > 0.0f ? 1 : -1;
    if (!(s * y < gap)) { /* (13): cases 1 and 3 */
        ep->dz = s * gap;
        ep->z = s * point->z_ss;
        ep->z_low = 0.0f;
        return s;
    }
    ep->dz = y;
    const deflection_t next = add((deflection_t){ep->z, ep->z_low}, y);
    ep->z = next.high;
    ep->z_low = next.low;
    return s;
}

float epf_f32_advance(epf_f32_t *ep, float dx)
{
    (void)move(ep, published_point(ep), dx);
    return ep->z;
}

float epf_f32_update(epf_f32_t *ep, float dx, float v)
{
    epf_f32_set_velocity(ep, v);
    return epf_f32_advance(ep, dx);
}

/* ---- the force: eq. (14) -------------------------------------------------------------------- */

static inline float publish_force(epf_f32_t *ep, float force)
{
    *(volatile float *)&ep->force = force;
    return force;
}

float epf_f32_output(const epf_f32_t *ep)
{
    return *(const volatile float *)&ep->force;
}

/* sigma_1 dz/dt, 0 for an unusable dt */
static inline float damping(epf_f32_t *ep, float dt)
{
    if (!is_positive_and_finite(dt)) {
        reject(ep);
        return 0.0f;
    }
    return ep->coeffs->sigma_1 * ep->dz / dt;
}

/* The sum of the terms. In case 1 the damping term opposes the others: the passivity guard leaves
   2^-10 of these, which is far above rounding, and far below what is felt. */
static inline float guarded_sum(const epf_f32_t *ep, float s, float others, float damped)
{
    const float force = others + damped;
    if (s * ep->dz < 0.0f) { /* case 1 */
        const float least = others * (1.0f / 1024.0f);
        return s * force < s * least ? least : force;
    }
    return force;
}

/* A term that cannot make the sum overflow. NaN is 0 times infinity: no viscosity at any speed. */
static inline float limited(float term)
{
    return is_nan(term) ? 0.0f : within(term, TERM_MAX);
}

static float saturated_force(epf_f32_t *ep, float s, float elastic, float viscous, float damped)
{
    return publish_force(ep, guarded_sum(ep, s, elastic + limited(viscous), limited(damped)));
}

/* s is sgn dx of the last displacement */
static inline float resist(epf_f32_t *ep, float s, float v, float dt)
{
    const float v_along = s * v < 0.0f ? -v : v;
    const float elastic = ep->coeffs->sigma_0 * ep->z;
    const float viscous = ep->coeffs->sigma_2 * v_along;
    const float damped = damping(ep, dt);
    const float force = guarded_sum(ep, s, elastic + viscous, damped); /* (14) */
    if (!is_finite(force)) {
        return saturated_force(ep, s, elastic, viscous, damped);
    }
    return publish_force(ep, force);
}

float epf_f32_force(epf_f32_t *ep, float dt)
{
    return resist(ep, ep->direction, published_point(ep)->v, dt);
}

float epf_f32_step(epf_f32_t *ep, float dx, float v, float dt)
{
    epf_f32_point_t point = operating_point(ep->coeffs, v);
    if (!is_usable(point)) {
        epf_f32_set_velocity(ep, v);
        point = *published_point(ep);
    }
    const float s = move(ep, &point, dx);
    const float force = resist(ep, s, point.v, dt);
    ep->points[ep->published] = point; /* in place: no other context reads it meanwhile */
    return force;
}

/* ---- start-up ------------------------------------------------------------------------------- */

epf_status_t epf_f32_coeffs_init(epf_f32_coeffs_t *coeffs, const epf_params_t *params)
{
    if (coeffs == NULL) {
        return EPF_ERR_NULL;
    }
    const epf_status_t status = epf_params_check(params);
    if (status != EPF_OK) {
        return status;
    }
    const epf_params_t p = *params;
    *coeffs = (epf_f32_coeffs_t)EPF_F32_DERIVE_(p.sigma_0, p.sigma_1, p.sigma_2, p.f_c, p.f_max,
                                                p.v_s, p.z_ba, p.stribeck);
    return EPF_OK;
}

void epf_f32_init(epf_f32_t *ep, const epf_f32_coeffs_t *coeffs)
{
    *ep = (epf_f32_t){.coeffs = coeffs};
    epf_f32_set_velocity(ep, 0.0f);
}

void epf_f32_reset(epf_f32_t *ep, float z)
{
    if (is_nan(z)) {
        reject(ep);
        z = 0.0f;
    }
    ep->z = within(z, ep->coeffs->z_max);
    ep->z_low = 0.0f;
    ep->dz = 0.0f;
    ep->direction = 0;
    (void)publish_force(ep, ep->coeffs->sigma_0 * ep->z);
}

float epf_f32_z(const epf_f32_t *ep)
{
    return *(const volatile float *)&ep->z;
}
