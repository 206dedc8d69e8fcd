/* SPDX-License-Identifier: MIT */
/*
 * libFuzzer drives parameters and inputs: no accepted contact and no input may break a sentence of
 * f32.h. What it is given is not taken bit by bit alone, for that would seldom hit what matters, but
 * also as neighbours and multiples of the contact's own lengths, in every exponent.
 *
 * Linked with tests/theorems/{f32_properties,f32_step}.c and the library.
 */
#include "../theorems/f32_properties.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void require(int condition)
{
    if (!condition) {
        abort();
    }
}

void f32_check(const f32_step_t *step, bool condition, const char *claim)
{
    if (!condition) {
        char text[F32_STEP_TEXT];
        f32_step_describe(step, claim, text);
        (void)fprintf(stderr, "%s\n", text);
        abort();
    }
}

/* ---- the input ------------------------------------------------------------------------------ */

static const uint8_t *next, *end;

static unsigned take_byte(void)
{
    return next < end ? *next++ : 0u;
}

static float from_bits(uint32_t bits)
{
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static uint32_t bits_of(float x)
{
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static float take_any_bits(void)
{
    uint32_t bits = 0;
    for (int i = 0; i < 4; i++) {
        bits = bits << 8 | take_byte();
    }
    return from_bits(bits);
}

/* Up to 7 floats away from x, which is positive */
static float take_neighbour(float x)
{
    return from_bits(bits_of(x) + take_byte() % 15u - 7u);
}

/* Any power of two and 8 more bits */
static float take_magnitude(void)
{
    const unsigned exponent = take_byte();
    return from_bits((uint32_t)(exponent % 255u) << 23 | take_byte() << 15);
}

/* A value that has to do with one of the contact's own, or none */
static float take_value(const float *own, unsigned count)
{
    static const float special[] = {0.0f, 0x1p-149f, FLT_MIN, 1.0f, FLT_MAX, INFINITY, NAN};
    const unsigned kind = take_byte();
    const float s = kind & 1u ? -1.0f : 1.0f;
    switch (kind >> 1 & 7u) {
    case 0:
        return take_any_bits();
    case 1:
        return s * special[take_byte() % 7u];
    case 2:
        return s * take_magnitude();
    case 3:
        return s * take_neighbour(own[take_byte() % count]);
    case 4:
        return s * take_neighbour(2.0f * own[take_byte() % count]);
    default:
        return s * own[take_byte() % count] * (float)take_byte() / 64.0f;
    }
}

/* Contacts of every size; often with f_max next to f_c, and z_ba next to z_c or to 0 */
static epf_params_t take_params(void)
{
    const unsigned kind = take_byte();
    epf_params_t p = {0};
    p.stribeck = (epf_stribeck_t)(kind % 4u);
    p.update = kind & 128u ? EPF_UPDATE_MEAN_VALUE : EPF_UPDATE_SATURATED;
    p.sigma_0 = take_magnitude();
    p.sigma_1 = kind & 4u ? take_magnitude() : 0.0f;
    p.sigma_2 = kind & 8u ? take_magnitude() : 0.0f;
    p.f_c = take_magnitude();
    p.f_max = kind & 16u ? take_neighbour(p.f_c) : p.f_c * (1.0f + (float)take_byte() / 16.0f);
    p.v_s = take_magnitude();
    const float z_c = p.f_c / p.sigma_0;
    p.z_ba = kind & 32u ? take_neighbour(z_c) : z_c * (float)take_byte() / 256.0f;
    return kind & 64u ? (epf_params_t){take_any_bits(), take_any_bits(), take_any_bits(),
                                       take_any_bits(), take_any_bits(), take_any_bits(),
                                       take_any_bits(), p.stribeck,      p.update}
                      : p;
}

/* ---- what f32.h says ------------------------------------------------------------------------ */

static int same_bits(float a, float b)
{
    return bits_of(a) == bits_of(b);
}

static void same_state(const epf_f32_t *a, const epf_f32_t *b)
{
    const epf_f32_point_t *p = &a->points[a->published];
    const epf_f32_point_t *q = &b->points[b->published];
    require(same_bits(a->z, b->z) && same_bits(a->z_low, b->z_low) && same_bits(a->dz, b->dz));
    require(same_bits(a->force, b->force) && a->rejected == b->rejected);
    require(a->direction == b->direction && same_bits(p->v, q->v) && same_bits(p->z_ss, q->z_ss));
    require(same_bits(p->inv_z_ss, q->inv_z_ss) && same_bits(p->inv_span, q->inv_span));
}

static double exact_z(const epf_f32_t *ep)
{
    return (double)ep->z + (double)ep->z_low;
}

static int is_usable_time(float dt)
{
    return dt > 0.0f && dt <= FLT_MAX;
}

static void bounds_hold(const f32_step_t *step)
{
    const epf_f32_coeffs_t *c = step->after.coeffs;
    require(isfinite(step->force));
    require(fabsf(step->after.z) <= c->z_max);
    require(fabs(exact_z(&step->after)) <= (double)c->z_max);
    require(step->z_ss >= c->z_c && step->z_ss <= c->z_max);
    require(same_bits(epf_f32_output(&step->after), step->force));
    require(same_bits(epf_f32_z(&step->after), step->after.z));
    if (step->s != 0.0f) {
        require(step->zeta <= fmaxf(step->zeta_before, step->z_ss));
        require(step->zeta >= fminf(step->zeta_before, step->z_ss));
    } else {
        require(step->after.z == step->before.z && step->after.z_low == step->before.z_low);
    }
}

static void bad_values_are_counted(const f32_step_t *step)
{
    const unsigned bad = (unsigned)(isnan(step->dx) + isnan(step->v) + !is_usable_time(step->dt));
    require(step->after.rejected - step->before.rejected == bad);
    if (isnan(step->v)) {
        const epf_f32_t *old = &step->before;
        require(same_bits(step->z_ss, old->points[old->published].z_ss));
    }
    if (isnan(step->dx)) {
        require(same_bits(step->after.dz, step->before.dz));
        require(step->after.direction == step->before.direction);
    }
}

/* Theorem 3, where float can show it; Theorem 4 */
static void motion_dissipates(const f32_step_t *step)
{
    const epf_f32_coeffs_t *c = step->after.coeffs;
    if (step->s == 0.0f) {
        return;
    }
    const int is_plastic = step->zeta_before > c->z_ba || step->zeta > c->z_ba;
    if (is_plastic && c->sigma_0 * c->z_ba >= FLT_MIN && c->f_c >= 1024.0f * FLT_MIN) {
        require(step->s * step->force > 0.0f);
    }
    const double d = fmin((double)step->d, (double)FLT_MAX);
    const double z = (double)step->after.z;
    const double z_before = (double)step->before.z;
    const double gained = (double)c->sigma_0 / 2.0 * (z - z_before) * (z + z_before);
    const double range = fmin(d, 2.0 * (double)c->z_max) + (double)c->z_max;
    const double rounding = 4.0 * (double)FLT_EPSILON * (double)c->f_max * range;
    require((double)step->force * (double)step->s * d >= gained - rounding - 0x1p-140 * d);
}

/* Eq. (14), as long as no term is near the end of the range, nor the guard at work */
static void force_is_eq_14(const f32_step_t *step)
{
    const epf_f32_coeffs_t *c = step->after.coeffs;
    const epf_f32_t *ep = &step->after;
    const double speed = (double)ep->points[ep->published].v;
    const double v = ep->direction == 0 ? speed : ep->direction * fabs(speed);
    const double elastic = (double)c->sigma_0 * (double)ep->z;
    const double viscous = c->sigma_2 > 0.0f ? (double)c->sigma_2 * v : 0.0;
    const double damped =
        is_usable_time(step->dt) ? (double)c->sigma_1 * (double)ep->dz / (double)step->dt : 0.0;
    const double size = fabs(elastic) + fabs(viscous) + fabs(damped);
    if (ep->dz * (float)ep->direction < 0.0f || !(size < (double)FLT_MAX / 8.0) ||
        (damped != 0.0 && fabs((double)c->sigma_1 * (double)ep->dz) < (double)FLT_MIN)) {
        return;
    }
    const double tolerance = 4.0 * (double)FLT_EPSILON * size + (double)FLT_MIN;
    require(fabs((double)step->force - (elastic + viscous + damped)) <= tolerance);
}

static void pure_functions_are_in_range(const epf_f32_coeffs_t *c, float z, float v)
{
    const float f_ss = epf_f32_fss(c, v);
    const float alpha = epf_f32_alpha(c, z, v);
    require(alpha >= 0.0f && alpha <= 1.0f);
    require(v > 0.0f || v < 0.0f ? fabsf(f_ss) >= c->f_c && fabsf(f_ss) <= c->f_max : f_ss == 0.0f);
    require(same_bits(alpha, epf_f32_alpha(c, -z, -v)));
}

/* ---- one contact ---------------------------------------------------------------------------- */

static void same_in_parts(epf_f32_t ep, const f32_step_t *step)
{
    epf_f32_set_velocity(&ep, step->v);
    require(same_bits(epf_f32_advance(&ep, step->dx), step->after.z));
    require(same_bits(epf_f32_force(&ep, step->dt), step->force));
    same_state(&ep, &step->after);
}

static void mirror_image_follows(epf_f32_t *mirror, const f32_step_t *step)
{
    const float force = epf_f32_step(mirror, -step->dx, -step->v, step->dt);
    require(force == -step->force && mirror->z == -step->after.z);
}

static void reset_forgets(epf_f32_t *ep, float z)
{
    const uint32_t rejected = ep->rejected;
    epf_f32_reset(ep, z);
    const float expected = isnan(z) ? 0.0f : fmaxf(-ep->coeffs->z_max, fminf(z, ep->coeffs->z_max));
    require(ep->z == expected && ep->rejected - rejected == (uint32_t)isnan(z));
    require(same_bits(epf_f32_output(ep), ep->coeffs->sigma_0 * ep->z));
    epf_f32_t fresh;
    epf_f32_init(&fresh, ep->coeffs);
    fresh.rejected = ep->rejected;
    epf_f32_set_velocity(&fresh, ep->points[ep->published].v);
    epf_f32_reset(&fresh, expected);
    same_state(ep, &fresh);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    next = data;
    end = data + size;
    const epf_params_t params = take_params();
    epf_f32_coeffs_t c;
    if (epf_f32_coeffs_init(&c, &params) != EPF_OK) {
        return 0;
    }
    const float lengths[] = {c.z_max, c.z_c, c.z_ba, c.z_c - c.z_ba, c.z_max * 0x1p-24f};
    const float speeds[] = {params.v_s, params.v_s * 0x1p-12f, params.v_s * 0x1p12f};
    const float times[] = {1e-3f, 1e-6f, 1.0f};
    epf_f32_t ep, mirror;
    epf_f32_init(&ep, &c);
    epf_f32_init(&mirror, &c);
    while (next < end) {
        if (take_byte() % 16u == 0u) {
            const float z = take_value(lengths, 5);
            reset_forgets(&ep, z);
            epf_f32_reset(&mirror, -z);
        }
        const float dx = take_value(lengths, 5);
        const float v = take_value(speeds, 3);
        f32_step_t step = {.contact = "fuzzed",
                           .sequence = "fuzzed",
                           .params = &params,
                           .coeffs = &c,
                           .dx = dx,
                           .v = v,
                           .dt = take_value(times, 3)};
        f32_step_take(&step, &ep);
        bounds_hold(&step);
        bad_values_are_counted(&step);
        f32_rises_by_no_more_than_the_displacement(&step);
        f32_is_elastic_up_to_z_ba(&step);
        f32_lets_go_from_above_z_ss(&step);
        f32_gap_closes(&step);
        f32_leap_arrives(&step);
        motion_dissipates(&step);
        force_is_eq_14(&step);
        pure_functions_are_in_range(&c, ep.z, v);
        same_in_parts(step.before, &step);
        mirror_image_follows(&mirror, &step);
    }
    return 0;
}
