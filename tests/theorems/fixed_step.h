/* SPDX-License-Identifier: MIT */
/*
 * One step of either estimator in integers, in the direction-normalised form of the proofs: with
 * s = sgn dx, zeta = s z. 64 bits, so that the test's own arithmetic cannot overflow.
 */
#ifndef EPF_TESTS_FIXED_STEP_H
#define EPF_TESTS_FIXED_STEP_H

#include "fixed_variant.h"

typedef struct {
    const fixed_variant_t *variant;
    const any_coeffs_t *coeffs;
    fixed_lengths_t lengths;
    const char *contact, *sequence; /* names */
    unsigned index;                 /* in the sequence */
    const epf_params_t *params;
    const epf_lsb_t *lsb;
    int32_t dx, v; /* what the estimator was given */
    uint32_t dt;
    any_contact_t before, after; /* the contact */
    int32_t z_before, z;
    int32_t force;          /* as returned, lsb.f */
    int64_t internal_force; /* sigma_0 u */
    int64_t s, d;           /* sgn dx, |dx| in u */
    int64_t zeta_before, zeta;
    int64_t z_ss;
} fixed_step_t;

/* Gives dx, v and dt of the step to a contact, and sees what it makes of them */
void fixed_step_take(fixed_step_t *step, any_contact_t *ep);

/* Fails, naming the step, unless the condition holds. Of whoever runs the steps: a test or a fuzzer. */
void fixed_check(const fixed_step_t *step, bool condition, const char *claim);

/* The text that names it */
enum { FIXED_STEP_TEXT = 360 };
void fixed_step_describe(const fixed_step_t *step, const char *claim, char text[FIXED_STEP_TEXT]);

#endif
