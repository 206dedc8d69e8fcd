/* SPDX-License-Identifier: MIT */
/*
 * Algorithm 1 of the paper as one would transcribe it: single precision, the mathematical library,
 * divisions where the equations have them. What a user would otherwise have; the yardstick of the
 * tables. Without the guard, the checks and the precision of epf_f32.
 */
#ifndef NAIVE_H
#define NAIVE_H

#include <epf/params.h>

typedef struct {
    const epf_params_t *params;
    float z;
} naive_t;

/* |f_ss(v)|, eqs. (6) to (8) */
float naive_f_ss(const epf_params_t *p, float v);

/* Eq. (10), with the factor 1/2 that its print has lost */
float naive_alpha(float zeta, float z_ba, float z_ss);

float naive_step(naive_t *contact, float dx, float v, float dt);

#endif
