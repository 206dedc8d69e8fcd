/* SPDX-License-Identifier: MIT */
/*
 * Drives both fixed-point estimators through every sequence, for every contact, with encoders from
 * coarse to fine and sigma_1 well inside and far outside of eq. (22), and shows each step to a
 * visitor. The twin of f32_walk.h.
 */
#ifndef EPF_TESTS_FIXED_WALK_H
#define EPF_TESTS_FIXED_WALK_H

#include "fixed_variant.h"
#include "sequences.h"

#include <stdbool.h>

/* One step in integers, in the direction-normalised form of the proofs. 64 bits, so that the test's
   own arithmetic cannot overflow. */
typedef struct {
    const fixed_variant_t *variant;
    const char *contact;
    sequence_kind_t sequence;
    unsigned index;
    const epf_params_t *params;
    const epf_lsb_t *lsb;
    const epf_fixed_coeffs_t *coeffs;
    int32_t dx, v; /* what the estimator was given */
    uint32_t dt;
    int32_t z_before, z;
    int32_t force;          /* as returned, lsb.f */
    int64_t internal_force; /* sigma_0 u */
    int64_t s, d;           /* sgn dx, |dx| in u */
    int64_t zeta_before, zeta;
    int64_t z_ss;
} fixed_step_t;

typedef void (*fixed_visitor_t)(const fixed_step_t *step);

/* On an emulated core fewer samples: see effort.h */
void fixed_walk(unsigned samples, fixed_visitor_t visit);

/* The same for one variant and one contact */
void fixed_walk_contact(const fixed_variant_t *variant, const char *contact,
                        const epf_params_t *params, const epf_lsb_t *lsb, unsigned samples,
                        fixed_visitor_t visit);

/* Fails the running test, naming the step, unless the condition holds */
void fixed_check(const fixed_step_t *step, bool condition, const char *claim);

#endif
