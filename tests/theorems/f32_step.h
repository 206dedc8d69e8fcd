/* SPDX-License-Identifier: MIT */
/* One step of the float estimator in the direction-normalised form of the proofs: s = sgn dx, zeta = s z. */
#ifndef EPF_TESTS_F32_STEP_H
#define EPF_TESTS_F32_STEP_H

#include "epf/f32.h"

#include <stdbool.h>

typedef struct {
    const char *contact, *sequence; /* names */
    bool is_extreme;                /* of the sequence that is: infinities, giants */
    unsigned index;                 /* in the sequence */
    const epf_params_t *params;
    const epf_f32_coeffs_t *coeffs;
    float dx, v, dt;         /* what the estimator was given */
    epf_f32_t before, after; /* the contact */
    float z_before, z, force;
    float s, d;              /* sgn dx, |dx|; 0 and NaN where dx is NaN */
    float zeta_before, zeta; /* s z_{k-1}, s z_k */
    float z_ss;              /* |z_ss(v)| of this step */
} f32_step_t;

/* Gives dx, v and dt of the step to a contact, and sees what it makes of them */
void f32_step_take(f32_step_t *step, epf_f32_t *ep);

/* Fails, naming the step, unless the condition holds. Of whoever runs the steps: a test or a fuzzer. */
void f32_check(const f32_step_t *step, bool condition, const char *claim);

/* The text that names it */
enum { F32_STEP_TEXT = 400 };
void f32_step_describe(const f32_step_t *step, const char *claim, char text[F32_STEP_TEXT]);

#endif
