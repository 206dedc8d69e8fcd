/* SPDX-License-Identifier: MIT */
/*
 * One estimator, whichever variant of the library it is: motions in SI units go in, deflection and
 * force in SI units come out. What lies between, floats or integers, is the variant's own affair.
 */
#ifndef VARIANT_H
#define VARIANT_H

#include <epf/f32.h>
#include <epf/q15.h>
#include <epf/q31.h>

/* What happens from one row of a record to the next, SI units */
typedef struct {
    double dx, v, dt;    /* displacement, velocity, time */
    double end_x, end_t; /* where it leads: position and time since the first row */
} motion_t;

/* What an estimator makes of all motions so far */
typedef struct {
    double z_m, force_N;
    unsigned long rejected; /* values that it could not use */
} estimate_t;

typedef struct variant variant_t;

typedef struct {
    epf_f32_coeffs_t coeffs;
    epf_f32_t contact;
} estimator_f32_t;

/* What differs between q31 and q15: the types of the library */
typedef union {
    struct {
        epf_q31_coeffs_t coeffs;
        epf_q31_t contact;
    } q31;
    struct {
        epf_q15_coeffs_t coeffs;
        epf_q15_t contact;
    } q15;
} integers_t;

typedef struct {
    epf_lsb_t lsb;
    integers_t integers;
    int z_shift;
    int32_t force;         /* the last one, lsb.f */
    double x_counts;       /* position and time of the last row, whole numbers; */
    double t_counts;       /* in double, because no integer holds every one of them */
    unsigned long clipped; /* signals that did not fit their integers */
} estimator_fixed_t;

/* Must stay where it is once started: the contact refers to the coefficients beside it */
typedef struct {
    const variant_t *variant;
    union {
        estimator_f32_t f32;
        estimator_fixed_t fixed; /* q31 and q15 */
    } as;
} estimator_t;

/* The format of the integers, known to the fixed-point variants alone */
typedef struct fixed_format fixed_format_t;

struct variant {
    const char *name;
    const fixed_format_t *format; /* NULL: floats, which need no weights */

    /* Begins at rest. What the library says to the parameters and weights. */
    epf_status_t (*start)(estimator_t *estimator, const epf_params_t *params, const epf_lsb_t *lsb);
    void (*step)(estimator_t *estimator, const motion_t *motion);
    estimate_t (*estimate)(const estimator_t *estimator);
};

extern const variant_t variant_f32, variant_q31, variant_q15;

/* NULL if there is none of that name */
const variant_t *variant_find(const char *name);

/* Weights that suit these parameters, which must be valid; for a variant that has a format */
epf_lsb_t variant_default_lsb(const variant_t *variant, const epf_params_t *params);

/* Starts an estimator of that variant */
epf_status_t estimator_start(estimator_t *estimator, const variant_t *variant,
                             const epf_params_t *params, const epf_lsb_t *lsb);
void estimator_step(estimator_t *estimator, const motion_t *motion);
estimate_t estimator_estimate(const estimator_t *estimator);

#endif
