/* SPDX-License-Identifier: MIT */
/* The tool finds the functions path_... in the trace, and takes their names for the tables. The
   factor r of a path varies its operands, for what depends on their digits. */
#include "paths.h"

#include "contact.h"

#include <math.h>

#define FAST (20.0f * V_S) /* the Stribeck effect is over: z_ss is z_c */

static void both_ways(measure_t *measure, float z, float dx, float v, float dt)
{
    measure(z, dx, v, dt);
    measure(-z, -dx, -v, dt);
}

static void path_elastic(measure_t *measure, float r)
{
    both_ways(measure, -0.3f * Z_BA, 0.8f * Z_BA * r, V_S * r, 1e-3f * r);
}

/* On both halves of the sine */
static void path_mixed(measure_t *measure, float r)
{
    const float share = 1.2f * r - 0.4f; /* 0.28 to 0.8 */
    both_ways(measure, Z_BA + share * (Z_C - Z_BA), 2e-7f * r, FAST * r, 1e-3f * r);
}

static void path_sliding(measure_t *measure, float r)
{
    both_ways(measure, Z_BA + 0.9f * r * (Z_C - Z_BA), 4e-6f * r, FAST * r, 1e-3f * r);
}

/* z_ss falls below the deflection, slowly enough for the damping term to stay below the others */
static void path_case_1(measure_t *measure, float r)
{
    both_ways(measure, 0.95f * Z_MAX, 2e-7f * r, FAST * r, 0.1f * r);
}

/* The same at once: the passivity guard limits the damping term */
static void path_guard(measure_t *measure, float r)
{
    both_ways(measure, 0.95f * Z_MAX, 2e-7f * r, FAST * r, 1e-3f * r);
}

static void path_reversal(measure_t *measure, float r)
{
    both_ways(measure, -0.99f * Z_C, 1e-6f * r, FAST * r, 1e-3f * r);
}

static void path_standstill(measure_t *measure, float r)
{
    both_ways(measure, 0.99f * Z_C, 0.0f, V_S * r, 1e-3f * r);
}

/* Displacement without velocity: z_ss is z_max */
static void path_at_rest(measure_t *measure, float r)
{
    both_ways(measure, Z_C, 1e-6f * r, 0.0f, 1e-3f * r);
}

static void path_leap(measure_t *measure, float r)
{
    both_ways(measure, Z_BA, 4.0f * Z_MAX * r, V_S * r, 1e-3f * r);
}

/* Largest numbers, shortest and longest time */
static void path_extreme(measure_t *measure)
{
    both_ways(measure, INFINITY, INFINITY, INFINITY, LSB_T);
    both_ways(measure, INFINITY, INFINITY, INFINITY, 1e30f);
    both_ways(measure, -INFINITY, INFINITY, LSB_V, LSB_T);
}

/* What is rejected */
static void path_rejected(measure_t *measure)
{
    measure(NAN, NAN, NAN, 0.0f);
    measure(Z_BA, Z_BA, V_S, 0.0f);
}

void every_path(measure_t *measure)
{
    static const float operands[] = {0.57f, 0.83f, 1.0f}; /* other digits, other magnitudes */

    for (const float *r = operands; r != operands + sizeof operands / sizeof *operands; r++) {
        path_elastic(measure, *r);
        path_mixed(measure, *r);
        path_sliding(measure, *r);
        path_case_1(measure, *r);
        path_guard(measure, *r);
        path_reversal(measure, *r);
        path_standstill(measure, *r);
        path_at_rest(measure, *r);
        path_leap(measure, *r);
    }
    path_extreme(measure);
    path_rejected(measure);
}
