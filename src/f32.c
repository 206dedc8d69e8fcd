/* SPDX-License-Identifier: MIT */
/* The estimator in single precision. Read psi() for the update rule, epf_f32_force() for eq. (14).
 */
#include "epf/f32.h"

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

#define TERM_MAX        (FLT_MAX / 4.0f)        /* three terms of the force cannot overflow */
#define PASSIVITY_GUARD (1.0f - 1.0f / 1024.0f) /* far above rounding, far below what is felt */

static float absolute(float x)
{
    return x < 0.0f ? -x : x;
}

static float at_most(float x, float bound)
{
    return x < bound ? x : bound;
}

/* x in [-bound, bound]; x is not NaN */
static float within(float x, float bound)
{
    return x > bound ? bound : x < -bound ? -bound : x;
}

/* sgn x; 0 for NaN */
static int8_t sign(float x)
{
    return (int8_t)((x > 0.0f) - (x < 0.0f));
}

static int is_nan(float x)
{
    return x != x;
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
static float exp_minus(float q)
{
    const float t = q * 1.44269504f; /* log2 e */
    if (!(t < 126.0f)) {
        return 0.0f;
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

/* Where f_ss stands between f_c (0) and f_max (1) at a velocity other than 0 */
static float stribeck_weight(const epf_f32_coeffs_t *c, float v)
{
    const float ratio = v * c->inv_v_s;
    const float q = ratio * ratio;
    switch (c->stribeck) {
    case EPF_STRIBECK_COULOMB:
        return 0.0f; /* (6) */
    case EPF_STRIBECK_GAUSSIAN:
        return exp_minus(q); /* (7) */
    case EPF_STRIBECK_LORENTZIAN:
    default:
        return 1.0f / (1.0f + q); /* (8) */
    }
}

/* low + weight (high - low), which rounding must not carry beyond high */
static float between(float low, float high, float weight)
{
    return at_most(low + weight * (high - low), high);
}

/* |z_ss(v)|, eq. (9) */
static float steady_state(const epf_f32_coeffs_t *c, float v)
{
    return v == 0.0f ? c->z_max : between(c->z_c, c->z_max, stribeck_weight(c, v));
}

float epf_f32_fss(const epf_f32_coeffs_t *coeffs, float v)
{
    return (float)sign(v) * between(coeffs->f_c, coeffs->f_max, stribeck_weight(coeffs, v));
}

/* ---- plasticity: eq. (10) ------------------------------------------------------------------- */

/* 1/2 + 1/2 sin(pi (u - 1/2)) for 0 <= u <= 1, within 1e-6: sin(pi u/2) squared up to the middle,
   where the polynomial meets its mirror image; exact at both ends, and never outside of [0, 1] */
static float half_sine(float u)
{
    const float x = u < 0.5f ? u : 1.0f - u;
    const float q = x * x;
    const float sine = x * (1.57078185f - q * (0.645621415f - q * 0.0773930458f));
    return u < 0.5f ? sine * sine : 1.0f - sine * sine;
}

/* alpha for zeta = z sgn(dx) and z_ss > 0: the elastic range first, for it must cost least */
static float alpha_at(float zeta, float z_ba, float z_ss, float inv_span)
{
    if (zeta <= z_ba) {
        return 0.0f;
    }
    if (zeta >= z_ss) {
        return 1.0f;
    }
    return half_sine((zeta - z_ba) * inv_span);
}

float epf_f32_alpha(const epf_f32_coeffs_t *coeffs, float z, float v)
{
    if (sign(z) * sign(v) <= 0) {
        return 0.0f;
    }
    const float z_ss = steady_state(coeffs, v);
    return alpha_at(absolute(z), coeffs->z_ba, z_ss, 1.0f / (z_ss - coeffs->z_ba));
}

/* ---- the state: eqs. (12) and (13) ---------------------------------------------------------- */

/* The unevaluated sum high + low, |low| <= ulp(high)/2 */
typedef struct {
    float high, low;
} deflection_t;

/* z + y, exact to 48 bits (Knuth's two-sum). Never less than z for y >= 0, and odd. */
static deflection_t add(deflection_t z, float y)
{
    const float sum = z.high + y;
    const float y_seen = sum - z.high;
    const float lost = (z.high - (sum - y_seen)) + (y - y_seen);
    const float low = z.low + lost;
    const float high = sum + low;
    return (deflection_t){high, low - (high - sum)};
}

/* One displacement d > 0 in the direction of which the deflection is zeta. From 2 z_max on it
   always ends in z_ss, since 1 - alpha zeta/z_ss >= 1 - zeta/z_ss. */
static deflection_t psi(const epf_f32_coeffs_t *c, const epf_f32_point_t *point, deflection_t zeta,
                        float d)
{
    const deflection_t steady = {point->z_ss, 0.0f};

    if (zeta.high >= point->z_ss || d >= 2.0f * c->z_max) { /* case 1 */
        return steady;
    }
    const float alpha = alpha_at(zeta.high, c->z_ba, point->z_ss, point->inv_span);
    const float plastic = at_most(alpha * zeta.high * point->inv_z_ss, 1.0f);
    const float y = (1.0f - plastic) * d; /* (12) */
    const deflection_t next = add(zeta, y);
    return next.high < point->z_ss ? next : steady; /* (13), cases 2 and 3 */
}

static const epf_f32_point_t *published_point(const epf_f32_t *ep)
{
    return &ep->points[*(const volatile uint8_t *)&ep->published];
}

/* Volatile accesses keep their order: the index follows the point that it announces */
static void publish_point(epf_f32_t *ep, epf_f32_point_t point)
{
    const uint8_t aside = (uint8_t)(1u - ep->published);
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
    const float finite = within(v, FLT_MAX);
    const float z_ss = steady_state(ep->coeffs, finite);
    publish_point(ep,
                  (epf_f32_point_t){finite, z_ss, 1.0f / z_ss, 1.0f / (z_ss - ep->coeffs->z_ba)});
}

float epf_f32_advance(epf_f32_t *ep, float dx)
{
    if (is_nan(dx)) {
        reject(ep);
        return ep->z;
    }
    ep->direction = sign(dx);
    if (ep->direction == 0) {
        ep->dz = 0.0f;
        return ep->z;
    }
    const float s = (float)ep->direction;
    const deflection_t zeta = {s * ep->z, s * ep->z_low};
    const deflection_t next = psi(ep->coeffs, published_point(ep), zeta, s * dx);

    ep->dz = s * ((next.high - zeta.high) + (next.low - zeta.low));
    ep->z = s * next.high;
    ep->z_low = s * next.low;
    return ep->z;
}

float epf_f32_update(epf_f32_t *ep, float dx, float v)
{
    epf_f32_set_velocity(ep, v);
    return epf_f32_advance(ep, dx);
}

/* ---- the force: eq. (14) -------------------------------------------------------------------- */

static void publish_force(epf_f32_t *ep, float force)
{
    *(volatile float *)&ep->force = force;
}

float epf_f32_output(const epf_f32_t *ep)
{
    return *(const volatile float *)&ep->force;
}

/* sigma_1 dz/dt, 0 for an unusable dt. No product here can be NaN: all factors are finite. */
static float damping(epf_f32_t *ep, float dt)
{
    if (!(dt > 0.0f && dt <= FLT_MAX)) {
        reject(ep);
        return 0.0f;
    }
    return within(ep->coeffs->sigma_1 * ep->dz / dt, TERM_MAX);
}

float epf_f32_force(epf_f32_t *ep, float dt)
{
    const float s = (float)ep->direction;
    const float v = published_point(ep)->v;
    const float v_along = ep->direction != 0 ? s * absolute(v) : v;

    const float elastic = ep->coeffs->sigma_0 * ep->z;
    const float viscous = within(ep->coeffs->sigma_2 * v_along, TERM_MAX);
    float damped = damping(ep, dt);
    if (s * ep->dz < 0.0f) { /* case 1 */
        damped = within(damped, PASSIVITY_GUARD * (absolute(elastic) + absolute(viscous)));
    }
    const float force = elastic + damped + viscous; /* (14) */
    publish_force(ep, force);
    return force;
}

float epf_f32_step(epf_f32_t *ep, float dx, float v, float dt)
{
    (void)epf_f32_update(ep, dx, v);
    return epf_f32_force(ep, dt);
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
    publish_force(ep, ep->coeffs->sigma_0 * ep->z);
}

float epf_f32_z(const epf_f32_t *ep)
{
    return *(const volatile float *)&ep->z;
}
