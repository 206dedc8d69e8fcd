/* SPDX-License-Identifier: MIT */
/* The fixed-point variants behind one interface, so that one test speaks of both. */
#ifndef EPF_TESTS_FIXED_VARIANT_H
#define EPF_TESTS_FIXED_VARIANT_H

#include "epf/fixed.h"

typedef struct {
    const char *name;
    double signal_max; /* largest dx, v and force */
    double time_max;   /* largest dt */
    double accuracy;   /* |dz| of one step against double precision, z_max */
    epf_status_t (*coeffs_init)(epf_fixed_coeffs_t *, const epf_params_t *, const epf_lsb_t *);
    void (*init)(epf_fixed_t *, const epf_fixed_coeffs_t *);
    void (*reset)(epf_fixed_t *, int32_t z);
    void (*set_velocity)(epf_fixed_t *, int32_t v);
    int32_t (*advance)(epf_fixed_t *, int32_t dx);
    int32_t (*force)(epf_fixed_t *, uint32_t dt);
    int32_t (*step)(epf_fixed_t *, int32_t dx, int32_t v, uint32_t dt);
    int32_t (*output)(const epf_fixed_t *);
    int32_t (*fss)(const epf_fixed_coeffs_t *, int32_t v);
    int32_t (*alpha)(const epf_fixed_coeffs_t *, int32_t z, int32_t v);
    /* the force before it is rounded to lsb.f, in sigma_0 u: what the theorems speak of */
    int64_t (*internal_force)(const epf_fixed_t *, uint32_t dt);
} fixed_variant_t;

enum { FIXED_VARIANTS = 2 };

extern const fixed_variant_t q31_variant, q15_variant;
extern const fixed_variant_t *const fixed_variants[FIXED_VARIANTS];

#endif
