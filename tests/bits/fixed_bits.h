/* SPDX-License-Identifier: MIT */
/* Every bit that a fixed-point estimator returns, over one long sequence, in one number. */
#ifndef EPF_TESTS_FIXED_BITS_H
#define EPF_TESTS_FIXED_BITS_H

#include "fixed_variant.h"

/* A contact, its weights, and the coefficients that the macro makes of both */
typedef struct {
    epf_params_t params;
    epf_lsb_t lsb;
    any_coeffs_t coeffs;
} fixed_contact_t;

typedef struct {
    const fixed_variant_t *variant;
    int32_t largest; /* that dx, v and dt are given */
    const fixed_contact_t *contacts;
    int count;
    const char *names[UPDATE_RULES]; /* of the checksums */
    uint32_t checksums[UPDATE_RULES];
    uint32_t (*add_gains)(uint32_t checksum, const any_coeffs_t *); /* what differs by type */
} fixed_bits_t;

/* What q31_bits.c and q15_bits.c differ in; the test itself is in fixed_bits.c */
extern const fixed_bits_t fixed_bits;

#endif
