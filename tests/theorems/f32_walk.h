/* SPDX-License-Identifier: MIT */
/*
 * Drives the float estimator through every sequence, for every contact, by either update rule, with
 * sigma_1 well inside and far outside of eq. (22), and shows each step to a visitor.
 */
#ifndef EPF_TESTS_F32_WALK_H
#define EPF_TESTS_F32_WALK_H

#include "f32_step.h"

typedef void (*f32_visitor_t)(const f32_step_t *step);

/* On an emulated core fewer samples: see effort.h */
void f32_walk(unsigned samples, f32_visitor_t visit);

/* The same, and then contacts at the corners of what is valid, where double precision is no reference any
   more: lengths from 1e-30 m to 1e37 m, z_ba next to z_c, f_max next to f_c or far above it */
void f32_walk_corners_too(unsigned samples, f32_visitor_t visit);

/* A sample as the estimator takes it: giants become infinite, as they would in a user's program */
float f32_from_double(double x);

#endif
