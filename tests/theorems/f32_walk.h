/* SPDX-License-Identifier: MIT */
/*
 * Drives the float estimator through every sequence, for every contact, by either update rule, with
 * sigma_1 well inside and far outside of eq. (22), and shows each step to a visitor.
 */
#ifndef EPF_TESTS_F32_WALK_H
#define EPF_TESTS_F32_WALK_H

#include "epf/f32.h"
#include "sequences.h"

#include <stdbool.h>

/* One step, in the direction-normalised form of the proofs: s = sgn dx, zeta = s z */
typedef struct {
    const char *contact;
    sequence_kind_t sequence;
    unsigned index;
    const epf_params_t *params;
    const epf_f32_coeffs_t *coeffs;
    float dx, v, dt; /* what the estimator was given */
    float z_before, z, force;
    float z_low_before, z_low; /* what z has beyond float */
    float dz;
    float s, d;              /* sgn dx, |dx| */
    float zeta_before, zeta; /* s z_{k-1}, s z_k */
    float z_ss;              /* |z_ss(v)| of this step */
} f32_step_t;

typedef void (*f32_visitor_t)(const f32_step_t *step);

/* On an emulated core fewer samples: see effort.h */
void f32_walk(unsigned samples, f32_visitor_t visit);

/* The same, and then contacts at the corners of what is valid, where double precision is no reference any
   more: lengths from 1e-30 m to 1e37 m, z_ba next to z_c, f_max next to f_c or far above it */
void f32_walk_corners_too(unsigned samples, f32_visitor_t visit);

/* A sample as the estimator takes it: giants become infinite, as they would in a user's program */
float f32_from_double(double x);

/* Fails the running test, naming the step, unless the condition holds */
void f32_check(const f32_step_t *step, bool condition, const char *claim);

#endif
