/* SPDX-License-Identifier: MIT */
/*
 * The fixed-point variants behind one interface, so that one test speaks of both. Signals are as wide
 * as those of q31; a test keeps to signal_max and time_max of its variant.
 */
#ifndef EPF_TESTS_FIXED_VARIANT_H
#define EPF_TESTS_FIXED_VARIANT_H

#include "epf/q15.h"
#include "epf/q31.h"

#include "../sequences/parameter_sets.h" /* UPDATE_RULES */

#include <stdbool.h>

/* Coefficients and a contact of either type: a variant uses its own member */
typedef union {
    epf_q31_coeffs_t q31;
    epf_q15_coeffs_t q15;
} any_coeffs_t;

typedef union {
    epf_q31_t q31;
    epf_q15_t q15;
} any_contact_t;

/* The lengths among the coefficients, in u; a leap in counts */
typedef struct {
    int32_t z_max, z_c, z_ba;
    uint32_t unit, leap;
    int z_shift;
} fixed_lengths_t;

typedef struct {
    const char *name;
    int32_t signal_max; /* largest dx, v and force */
    uint32_t time_max;  /* largest dt */

    /* by update rule */
    double accuracy[UPDATE_RULES]; /* |dz| of one step against double precision, z_max */
    int32_t
        ripple[UPDATE_RULES]; /* so much less a longer displacement may deflect, by rounding, u */

    /* the public functions */
    epf_status_t (*coeffs_init)(any_coeffs_t *, const epf_params_t *, const epf_lsb_t *);
    void (*init)(any_contact_t *, const any_coeffs_t *);
    void (*reset)(any_contact_t *, int32_t z);
    void (*set_velocity)(any_contact_t *, int32_t v);
    int32_t (*advance)(any_contact_t *, int32_t dx);
    int32_t (*update)(any_contact_t *, int32_t dx, int32_t v);
    int32_t (*force)(any_contact_t *, uint32_t dt);
    int32_t (*step)(any_contact_t *, int32_t dx, int32_t v, uint32_t dt);
    int32_t (*output)(const any_contact_t *);
    int32_t (*z)(const any_contact_t *);
    int32_t (*fss)(const any_coeffs_t *, int32_t v);
    int32_t (*alpha)(const any_coeffs_t *, int32_t z, int32_t v);

    /* what can be seen of the two types */
    fixed_lengths_t (*lengths)(const any_coeffs_t *);
    bool (*same_coeffs)(const any_coeffs_t *, const any_coeffs_t *);    /* in every field */
    bool (*same_contact)(const any_contact_t *, const any_contact_t *); /* in every field */
    bool (*same_point)(const any_contact_t *, const any_contact_t *, int which); /* 0 or 1 */
    int (*published)(const any_contact_t *);   /* which of the two */
    int32_t (*z_ss)(const any_contact_t *);    /* of the published operating point, u */
    int32_t (*viscous)(const any_contact_t *); /* likewise, 2^8 sigma_0 u */
    uint16_t *(*rejected)(any_contact_t *);

    /* what only the theorems and the bounds of accuracy speak of: terms in 2^8 sigma_0 u */
    int64_t (*internal_force)(const any_contact_t *, uint32_t dt); /* sigma_0 u, before rounding */
    uint32_t (*damping_term)(const any_coeffs_t *, uint32_t distance, uint32_t dt);
    uint32_t (*viscous_term)(const any_coeffs_t *, uint32_t speed);
    int32_t (*in_lsb)(const any_coeffs_t *, int32_t z, int32_t terms);
} fixed_variant_t;

enum { FIXED_VARIANTS = 2 };

extern const fixed_variant_t q31_variant, q15_variant;
extern const fixed_variant_t *const fixed_variants[FIXED_VARIANTS];

/* Every variant by every update rule */
enum { FIXED_WAYS = FIXED_VARIANTS * UPDATE_RULES };

static inline const fixed_variant_t *fixed_way_variant(int i)
{
    return fixed_variants[i % FIXED_VARIANTS];
}

static inline epf_update_t fixed_way_rule(int i)
{
    return (epf_update_t)(i / FIXED_VARIANTS);
}

#endif
