/* SPDX-License-Identifier: MIT */
/* The tool finds the functions path_... in the trace, and takes their names for the tables. The
   factor r of a path varies its operands, for what depends on their digits. */
#include "paths.h"

#include <float.h>
#include <math.h>

/* The contact, and who measures it */
typedef struct {
    measure_t *measure;
    float z_ba, z_c, z_max, v_s;
} scene_t;

static void both_ways(const scene_t *at, float z, float dx, float v, float dt)
{
    at->measure((motion_t){z, dx, v, dt});
    at->measure((motion_t){-z, -dx, -v, dt});
}

/* A deflection where displacements are half plastic */
static float halfway(const scene_t *at)
{
    return at->z_ba + 0.5f * (at->z_c - at->z_ba);
}

static void path_elastic(const scene_t *at, float r, float v)
{
    both_ways(at, -0.3f * at->z_ba, 0.8f * at->z_ba * r, v, 1e-3f * r);
}

/* On both halves of the sine */
static void path_mixed(const scene_t *at, float r, float v)
{
    const float share = 1.2f * r - 0.4f; /* 0.28 to 0.8 */
    both_ways(at, at->z_ba + share * (at->z_c - at->z_ba), 0.025f * at->z_ba * r, v, 1e-3f * r);
}

/* From the elastic range into the sine: what lies below z_ba is elastic */
static void path_crossing(const scene_t *at, float r, float v)
{
    both_ways(at, 0.9f * at->z_ba, 0.3f * at->z_ba * r, v, 1e-3f * r);
}

/* The same, many times as far as the sine is long, but no leap */
static void path_sweep(const scene_t *at, float r, float v)
{
    both_ways(at, 0.5f * at->z_ba, 1.9f * at->z_max * r, v, 1e-3f * r);
}

static void path_sliding(const scene_t *at, float r, float v)
{
    both_ways(at, at->z_ba + 0.9f * r * (at->z_c - at->z_ba), 0.5f * at->z_ba * r, v, 1e-3f * r);
}

/* z_ss falls below the deflection, slowly enough for the damping term to stay below the others */
static void path_case_1(const scene_t *at, float r, float v)
{
    both_ways(at, 0.95f * at->z_max, 0.025f * at->z_ba * r, v, 0.1f * r);
}

/* The same at once: the passivity guard limits the damping term */
static void path_guard(const scene_t *at, float r, float v)
{
    both_ways(at, 0.98f * at->z_max, 0.2f * at->z_ba * r, v, 1e-4f * r);
}

/* The same as far as z_ss, also by the mean-value rule */
static void path_release(const scene_t *at, float r, float v)
{
    both_ways(at, 0.98f * at->z_max, 1.95f * at->z_max * r, v, 1e-3f * r);
}

static void path_reversal(const scene_t *at, float r, float v)
{
    both_ways(at, -0.99f * at->z_c, 0.125f * at->z_ba * r, v, 1e-3f * r);
}

static void path_standstill(const scene_t *at, float r, float v)
{
    both_ways(at, 0.99f * at->z_c, 0.0f, v, 1e-3f * r);
}

static void path_leap(const scene_t *at, float r, float v)
{
    both_ways(at, at->z_ba, 4.0f * at->z_max * r, v, 1e-3f * r);
}

/* Displacement without velocity: z_ss is z_max */
static void path_at_rest(const scene_t *at, float r)
{
    both_ways(at, at->z_c, 0.125f * at->z_ba * r, 0.0f, 1e-3f * r);
}

/* Largest numbers and least, shortest and longest time */
static void path_extreme(const scene_t *at)
{
    both_ways(at, INFINITY, INFINITY, INFINITY, FLT_MIN);
    both_ways(at, INFINITY, INFINITY, INFINITY, FLT_MAX);
    both_ways(at, INFINITY, FLT_MIN, INFINITY, FLT_MIN);
    both_ways(at, -INFINITY, INFINITY, FLT_MIN, FLT_MIN);
    both_ways(at, INFINITY, FLT_MIN, FLT_MIN, FLT_MAX);
    both_ways(at, INFINITY, FLT_MIN, at->v_s, FLT_MIN);
    both_ways(at, halfway(at), 0.025f * at->z_ba, at->v_s, FLT_MIN);
    both_ways(at, halfway(at), at->z_ba, at->v_s, FLT_MIN);
    both_ways(at, halfway(at), at->z_ba, INFINITY, FLT_MIN);
}

/* What is rejected, alone and together */
static void path_rejected(const scene_t *at)
{
    at->measure((motion_t){NAN, NAN, NAN, 0.0f});
    both_ways(at, halfway(at), NAN, at->v_s, 1e-3f);
    both_ways(at, halfway(at), 0.025f * at->z_ba, NAN, NAN);
    both_ways(at, halfway(at), 0.025f * at->z_ba, NAN, FLT_MIN);
    both_ways(at, at->z_max, 0.025f * at->z_ba, NAN, FLT_MIN);
    both_ways(at, halfway(at), 0.025f * at->z_ba, at->v_s, 0.0f);
    both_ways(at, at->z_max, 0.025f * at->z_ba, at->v_s, 0.0f);
}

/* Where the Stribeck effect is in full swing, and where it is over: z_ss is z_c */
static void at_each_speed(const scene_t *at, float r)
{
    const float speeds[] = {1.0f, 20.0f};
    for (int i = 0; i < 2; i++) {
        const float v = speeds[i] * at->v_s * r;
        path_elastic(at, r, v);
        path_mixed(at, r, v);
        path_crossing(at, r, v);
        path_sweep(at, r, v);
        path_sliding(at, r, v);
        path_case_1(at, r, v);
        path_guard(at, r, v);
        path_release(at, r, v);
        path_reversal(at, r, v);
        path_standstill(at, r, v);
        path_leap(at, r, v);
    }
}

void every_path(const contact_t *contact, measure_t *measure)
{
    static const float operands[] = {0.83f, 1.0f, 0.57f}; /* other digits, other magnitudes */
    const epf_params_t *p = &contact->params;
    const scene_t scene = {measure, p->z_ba, p->f_c / p->sigma_0, p->f_max / p->sigma_0, p->v_s};

    for (int i = 0; i < contact->operands; i++) {
        at_each_speed(&scene, operands[i]);
        path_at_rest(&scene, operands[i]);
    }
    path_extreme(&scene);
    path_rejected(&scene);
}
