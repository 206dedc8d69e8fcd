/* SPDX-License-Identifier: MIT */
/* The estimator in single precision. Read course() for eqs. (12) and (13),
   mean_value_f32.h for the other update rule, epf_f32_force() for (14).
   The common path of each function is free of special cases: what is unusable, or beyond the range of
   float, fails one of its comparisons and goes another way. */
#include "epf/f32.h"

#include "ieee.h" /* before all that computes */

#include "compiler.h"
#include "deflection.h"
#include "only.h"

#include <stddef.h>

#define TERM_MAX (FLT_MAX / 4.0f) /* three terms of the force cannot overflow */

/* ---- floats, and their bits ----------------------------------------------------------------- */

static inline uint32_t bits_of(float x)
{
    const union {
        float value;
        uint32_t bits;
    } same = {x};
    return same.bits;
}

static inline float from_bits(uint32_t bits)
{
    const union {
        uint32_t bits;
        float value;
    } same = {bits};
    return same.value;
}

static inline int is_negative(float x)
{
    return (int32_t)bits_of(x) < 0;
}

static inline int is_zero(float x)
{
    return bits_of(x) << 1 == 0;
}

static inline float magnitude(float x)
{
#ifdef __GNUC__
    return __builtin_fabsf(x); /* one instruction */
#else
    return from_bits(bits_of(x) & 0x7fffffffu);
#endif
}

/* A normal number below 2^126: of such a one the reciprocal is normal too */
static inline int has_reciprocal(float x)
{
    return bits_of(x) - 0x00800000u < 0x7e000000u;
}

/* 1 or -1 */
static inline float sign_of(float x)
{
    return from_bits((bits_of(x) & 0x80000000u) | 0x3f800000u);
}

static inline int8_t direction_of(float x)
{
    return (int8_t)((int32_t)bits_of(x) >> 31 | 1);
}

static inline float positive_part(float x)
{
    return from_bits(bits_of(x) & ~(uint32_t)((int32_t)bits_of(x) >> 31));
}

static inline float at_most(float x, float bound)
{
    return x < bound ? x : bound;
}

/* x in [-bound, bound]; x is not NaN */
static inline float within(float x, float bound)
{
    return x > bound ? bound : x < -bound ? -bound : x;
}

static inline int is_nan(float x)
{
    return x != x;
}

/* x - x is 0 for a number, and NaN for infinity and NaN */
static inline int is_finite(float x)
{
    return x - x == 0.0f;
}

static inline int is_positive_and_finite(float x)
{
    return x > x - x;
}

/* It saturates instead of wrapping */
static inline void reject(epf_f32_t *ep)
{
    ep->rejected += ep->rejected != UINT32_MAX;
}

/* ---- steady state: eqs. (6) to (9) ---------------------------------------------------------- */

/* exp(-q) for q >= 0, within 3e-7: 2^-n by its bit pattern, times 2^-r, 0 <= r < 1, by a polynomial
   that is exact at both ends, so that the pieces join */
static IN_LINE float exp_minus(float q)
{
    const float t = q * 1.44269504f; /* log2 e */
    if (!(t < 126.0f)) {
        return is_nan(t) ? t : 0.0f;
    }
    const uint32_t n = (uint32_t)t;
    const float r = t - (float)n;
    const float power = from_bits((127u - n) << 23);
    const float bend =
        -0.193144184f + r * (0.0470398227f + r * (-0.00826757329f + r * 0.000948424026f));
    return power * (1.0f - r * (0.5f - (1.0f - r) * bend));
}

/* What f_ss(v) or z_ss(v) has beyond f_c or z_c: at rest all of the excess. NaN stays NaN. */
static IN_LINE float stribeck(const epf_f32_coeffs_t *c, float excess, float v)
{
    const epf_stribeck_t form = form_in_use(c->stribeck);
    const float ratio = v * c->inv_v_s;
    const float q = ratio * ratio;
    if (LIKELY(form == EPF_STRIBECK_LORENTZIAN)) {
        return excess / (1.0f + q); /* (8) */
    }
    if (form == EPF_STRIBECK_GAUSSIAN) {
        return excess * exp_minus(q); /* (7) */
    }
    return is_nan(v) ? v : v == 0.0f ? excess : 0.0f; /* (6) */
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

static inline const epf_f32_point_t *published_point(const epf_f32_t *ep)
{
    return ep->points + *(const volatile uint8_t *)&ep->published;
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

/* Both reciprocals by one division, where the product is within its reach. Returns 0 for NaN. */
static IN_LINE int make_point(epf_f32_point_t *point, const epf_f32_coeffs_t *c, float v)
{
    const float z_ss = steady_state(c, v);
    const float span = z_ss - c->z_ba;
    const float product = z_ss * span;
    if (LIKELY(has_reciprocal(product))) {
        const float both = 1.0f / product;
        *point = (epf_f32_point_t){v, z_ss, both * span, both * z_ss};
        return 1;
    }
    *point = (epf_f32_point_t){v, z_ss, 1.0f / z_ss, 1.0f / span};
    return !is_nan(v);
}

void epf_f32_set_velocity(epf_f32_t *ep, float v)
{
    epf_f32_point_t point;
    if (!LIKELY(make_point(&point, ep->coeffs, v))) {
        reject(ep);
        return;
    }
    publish_point(ep, point);
}

/* ---- plasticity: eq. (10) ------------------------------------------------------------------- */

/* 1 - alpha between z_ba and z_ss, where u = (z_ss - zeta)/(z_ss - z_ba): the half period of a sine,
   which is its own mirror image, within 8e-7. Exact at both ends, level there, and never outside of
   [0, 1], nor for a u that rounding has carried beyond 1. */
static inline float elastic_share(float u)
{
    const float beyond = 1.0f - u; /* (zeta - z_ba)/(z_ss - z_ba) */
    const float m = u * beyond;
    return u * (1.0f + (u - beyond) * beyond * (1.0f + m * (0.532088035f + m * 0.136793624f)));
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

/* (1 - alpha zeta/z_ss) dx, eq. (12), from the gap z_ss - zeta > 0, and as precise as that: the last
   of the gap closes too */
static inline float deflecting_part(const epf_f32_point_t *point, float gap, float dx)
{
    const float part = gap * (dx * point->inv_z_ss); /* (1 - zeta/z_ss) dx */
    return part + elastic_share(gap * point->inv_span) * (dx - part);
}

/* Where dx leads from z. In its direction s the deflection is zeta = s z, and the gap z_ss - zeta,
   in case 1 not positive. */
typedef struct {
    deflection_t z;
    float s, gap;
    float y; /* eq. (12) */
} course_t;

static IN_LINE course_t course(const epf_f32_t *ep, const epf_f32_point_t *point, float z_ba,
                               float dx)
{
    const float s = sign_of(dx);
    const deflection_t z = {ep->z, ep->z_low};
    const float zeta = s * z.high;
    const float gap = gap_of(z, s, point->z_ss);
    float y = dx;
    if (LIKELY(zeta > z_ba)) {
        y = deflecting_part(point, gap, dx);
    }
    return (course_t){z, s, gap, y};
}

/* Eq. (13): does zeta + y stay below z_ss? A y below the gap, both rounded, cannot carry the sum above
   it. Not in case 1, nor for NaN. */
static inline int stays_below(const course_t *to)
{
    return magnitude(to->y) < to->gap;
}

static inline void keep(epf_f32_t *ep, float dx, deflection_t z, float dz)
{
    ep->direction = direction_of(dx);
    ep->z = z.high;
    ep->z_low = z.low;
    ep->dz = dz;
}

static inline void stand_still(epf_f32_t *ep)
{
    ep->dz = 0.0f;
    ep->direction = 0;
}

/* EPF_UPDATE_SATURATED, the rule of the paper */
static IN_LINE float advance_saturated(epf_f32_t *ep, float dx)
{
    const epf_f32_point_t *point = published_point(ep);
    const course_t to = course(ep, point, ep->coeffs->z_ba, dx);
    deflection_t z = {to.s * point->z_ss, 0.0f};
    if (LIKELY(stays_below(&to))) {
        z = sum_of(to.z, to.y);
        keep(ep, dx, z, to.y);
    } else if (is_nan(dx)) {
        reject(ep);
        z = to.z;
    } else {
        keep(ep, dx, z, to.s * to.gap); /* cases 1 and 3 */
    }
    return z.high;
}

/* ---- EPF_UPDATE_MEAN_VALUE ------------------------------------------------------------------- */

#include "mean_value_f32.h"

static IN_LINE float move_by(epf_f32_t *ep, deflection_t z, float dx, float dz)
{
    const deflection_t next = sum_of(z, dz);
    keep(ep, dx, next, dz);
    return next.high;
}

static IN_LINE float advance_by_mean_value(epf_f32_t *ep, float dx)
{
    const epf_f32_point_t *point = published_point(ep);
    const float s = sign_of(dx), d = magnitude(dx);
    const epf_f32_coeffs_t *c = ep->coeffs;
    const deflection_t z = {ep->z, ep->z_low};
    const float gap = gap_of(z, s, point->z_ss);
    const float room = gap_of(z, s, c->z_ba);
    if (d < room) {
        return move_by(ep, z, dx, dx); /* all elastic */
    }
    /* whatever falls through arrives in z_ss */
    if (LIKELY(d < 2.0f * c->z_max)) { /* more says nothing about the way: it ends in z_ss */
        if (LIKELY(gap > 0.0f)) {
            const float dzeta = mean_value(point, c->z_ba, room, gap, d);
            if (LIKELY(dzeta < gap)) {
                return move_by(ep, z, dx, s * dzeta);
            }
        } else {
            const float dzeta = let_go(point, gap, d);
            if (dzeta > gap) {
                return move_by(ep, z, dx, s * dzeta);
            }
        }
    } else if (is_nan(dx)) {
        reject(ep);
        return z.high;
    }
    keep(ep, dx, (deflection_t){s * point->z_ss, 0.0f}, s * gap);
    return s * point->z_ss;
}

/* ---- both rules ------------------------------------------------------------------------------ */

float epf_f32_advance(epf_f32_t *ep, float dx)
{
    if (!LIKELY(!is_zero(dx))) {
        stand_still(ep);
        return ep->z;
    }
    return LIKELY(rule_in_use(ep->coeffs->update) != EPF_UPDATE_SATURATED)
               ? advance_by_mean_value(ep, dx)
               : advance_saturated(ep, dx);
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

/* In case 1 the damping term opposes the others. Of these the passivity guard leaves 2^-10, which is
   far above rounding, and far below what is felt. */
static inline float least_of(float others)
{
    return others * (1.0f / 1024.0f);
}

static inline int is_case_1(const epf_f32_t *ep)
{
    return is_negative(ep->dz) != (ep->direction < 0);
}

static OUT_OF_LINE float guarded_force(epf_f32_t *ep, float others, float force)
{
    const float least = least_of(others);
    const int is_less = ep->direction < 0 ? force > least : force < least;
    return publish_force(ep, is_less ? least : force);
}

/* A term that cannot make the sum overflow. NaN is 0 times infinity: no viscosity at any speed. */
static inline float limited(float term)
{
    return is_nan(term) ? 0.0f : within(term, TERM_MAX);
}

/* Eq. (14) once more, where the common way is none: term by term */
static OUT_OF_LINE float unusual_force(epf_f32_t *ep, float viscous, float damped, float dt)
{
    const epf_f32_coeffs_t *c = ep->coeffs;
    if (!is_positive_and_finite(dt)) {
        reject(ep);
        damped = 0.0f;
    } else if (!is_finite(damped)) {
        damped = c->sigma_1 / dt * ep->dz; /* sigma_1 dz may be beyond float where this is not */
    }
    const float others = c->sigma_0 * ep->z + limited(viscous);
    const float force = others + limited(damped);
    return is_case_1(ep) ? guarded_force(ep, others, force) : publish_force(ep, force);
}

/* dt is positive, and both are finite */
static inline int are_usable(float force, float dt)
{
    const float sum = magnitude(force) + dt;
    return dt > sum - sum;
}

float epf_f32_force(epf_f32_t *ep, float dt)
{
    const epf_f32_coeffs_t *c = ep->coeffs;
    const float v = published_point(ep)->v;
    const int s = ep->direction;
    const float v_along = s == 0 ? v : s < 0 ? -magnitude(v) : magnitude(v);
    const float viscous = c->sigma_2 * v_along;
    const float others = c->sigma_0 * ep->z + viscous;
    const float damped = c->sigma_1 * ep->dz / dt;
    const float force = others + damped;
    if (!LIKELY(are_usable(force, dt))) {
        return unusual_force(ep, viscous, damped, dt);
    }
    if (!LIKELY(!is_case_1(ep))) {
        return guarded_force(ep, others, force);
    }
    return publish_force(ep, force);
}

/* ---- all in one: step ----------------------------------------------------------------------- */

static OUT_OF_LINE float step_by_calls(epf_f32_t *ep, float dx, float v, float dt)
{
    epf_f32_set_velocity(ep, v);
    (void)epf_f32_advance(ep, dx);
    return epf_f32_force(ep, dt);
}

/* The bits of set_velocity, advance and force, without their way through memory */
float epf_f32_step(epf_f32_t *ep, float dx, float v, float dt)
{
    const epf_f32_coeffs_t *c = ep->coeffs;
    if (!LIKELY(rule_in_use(c->update) == EPF_UPDATE_SATURATED)) {
        return step_by_calls(ep, dx, v, dt);
    }
    const float z_ba = c->z_ba;
    epf_f32_point_t point;
    if (LIKELY(make_point(&point, c, v))) {
        publish_point(ep, point);
    } else {
        reject(ep);
        point = *published_point(ep);
    }
    if (!LIKELY(!is_zero(dx))) {
        stand_still(ep);
        return epf_f32_force(ep, dt);
    }
    const course_t to = course(ep, &point, z_ba, dx);
    if (LIKELY(stays_below(&to))) {
        const deflection_t z = sum_of(to.z, to.y);
        const float viscous = c->sigma_2 * (to.s * magnitude(point.v));
        const float others = c->sigma_0 * z.high + viscous;
        const float damped = c->sigma_1 * to.y / dt;
        const float force = others + damped;
        keep(ep, dx, z, to.y);
        if (!LIKELY(are_usable(force, dt))) {
            return unusual_force(ep, viscous, damped, dt);
        }
        return publish_force(ep, force);
    }
    if (!LIKELY(magnitude(to.y) >= to.gap) && is_nan(dx)) { /* NaN is neither below nor above */
        reject(ep);
        return epf_f32_force(ep, dt);
    }
    /* cases 1 and 3: all terms in the direction of the motion, where only the damping may oppose */
    const float viscous = c->sigma_2 * magnitude(point.v);
    const float others = c->sigma_0 * point.z_ss + viscous;
    const float damped = c->sigma_1 * to.gap / dt;
    const float force = others + damped;
    keep(ep, dx, (deflection_t){to.s * point.z_ss, 0.0f}, to.s * to.gap);
    if (!LIKELY(are_usable(force, dt))) {
        return unusual_force(ep, to.s * viscous, to.s * damped, dt);
    }
    const float least = least_of(others);
    return publish_force(ep, to.s * (force < least ? least : force));
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
                                                p.v_s, p.z_ba, p.stribeck, p.update);
    return EPF_OK;
}

/* Puts the state to z, and ends the motion that led to another */
static inline void rest_at(epf_f32_t *ep, float z)
{
    ep->z = z;
    ep->z_low = 0.0f;
    stand_still(ep);
    (void)publish_force(ep, ep->coeffs->sigma_0 * z);
}

/* Field by field: an initialiser may become a call of memset */
void epf_f32_init(epf_f32_t *ep, const epf_f32_coeffs_t *coeffs)
{
    ep->coeffs = coeffs;
    ep->rejected = 0;
    ep->published = 0;
    rest_at(ep, 0.0f);
    epf_f32_set_velocity(ep, 0.0f);
}

void epf_f32_reset(epf_f32_t *ep, float z)
{
    if (is_nan(z)) {
        reject(ep);
        z = 0.0f;
    }
    rest_at(ep, within(z, ep->coeffs->z_max));
}

float epf_f32_z(const epf_f32_t *ep)
{
    return *(const volatile float *)&ep->z;
}
