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

float naive_step(naive_t *contact, float dx, float v, float dt);

#endif
