/* SPDX-License-Identifier: MIT */
/*
 * The variants on integers, fed as firmware feeds them: an encoder that counts, a velocity in whole
 * numbers, a timer that ticks. q31 and q15 share all but the width of the signals.
 */
#include "saturate.h"
#include "variant.h"

#include <math.h>

struct fixed_format {
    epf_status_t (*start)(integers_t *integers, const epf_params_t *params, const epf_lsb_t *lsb);
    int32_t (*step)(integers_t *integers, int32_t dx, int32_t v, uint32_t dt);
    int32_t (*z)(const integers_t *integers);
    int (*z_shift)(const integers_t *integers);
    unsigned long (*rejected)(const integers_t *integers);
    int32_t signal_max; /* largest dx and v */
    uint32_t dt_max;
    /* The weights by default */
    float z_max_counts; /* so many of displacement make z_max, and so many of force f_max */
    float v_s_counts;   /* so many of velocity make v_s */
    float tick;         /* s */
};

/* The functions of a variant Q of the library, whose signals and times have these types */
#define FUNCTIONS_OF(Q, signal_t, duration_t)                                                   \
    static epf_status_t Q##_start(integers_t *integers, const epf_params_t *params,             \
                                  const epf_lsb_t *lsb)                                         \
    {                                                                                           \
        const epf_status_t status = epf_##Q##_coeffs_init(&integers->Q.coeffs, params, lsb);    \
        if (status == EPF_OK) {                                                                 \
            epf_##Q##_init(&integers->Q.contact, &integers->Q.coeffs);                          \
        }                                                                                       \
        return status;                                                                          \
    }                                                                                           \
    static int32_t Q##_step(integers_t *integers, int32_t dx, int32_t v, uint32_t dt)           \
    {                                                                                           \
        return epf_##Q##_step(&integers->Q.contact, (signal_t)dx, (signal_t)v, (duration_t)dt); \
    }                                                                                           \
    static int32_t Q##_z(const integers_t *integers)                                            \
    {                                                                                           \
        return epf_##Q##_z(&integers->Q.contact);                                               \
    }                                                                                           \
    static int Q##_z_shift(const integers_t *integers)                                          \
    {                                                                                           \
        return integers->Q.coeffs.z_shift;                                                      \
    }                                                                                           \
    static unsigned long Q##_rejected(const integers_t *integers)                               \
    {                                                                                           \
        return integers->Q.contact.rejected;                                                    \
    }
FUNCTIONS_OF(q31, int32_t, uint32_t)
FUNCTIONS_OF(q15, int16_t, uint16_t)

/* 2 z_max, from which on every dx does the same, just fits the 16 bits, and the force has as much
   headroom. Beyond 300 v_s f_ss(v) is level; only a viscous force would still grow. 65535 ticks of
   10 us are 0.65 s. */
static const fixed_format_t q15_format = {
    .start = q15_start,
    .step = q15_step,
    .z = q15_z,
    .z_shift = q15_z_shift,
    .rejected = q15_rejected,
    .signal_max = INT16_MAX,
    .dt_max = UINT16_MAX,
    .z_max_counts = 16000.0f,
    .v_s_counts = 100.0f,
    .tick = 1e-5f,
};

/* 32 bits are plenty: resolution and range both go far beyond what a record holds */
static const fixed_format_t q31_format = {
    .start = q31_start,
    .step = q31_step,
    .z = q31_z,
    .z_shift = q31_z_shift,
    .rejected = q31_rejected,
    .signal_max = INT32_MAX,
    .dt_max = UINT32_MAX,
    .z_max_counts = 1e6f,
    .v_s_counts = 1e5f,
    .tick = 1e-6f,
};

epf_lsb_t variant_default_lsb(const variant_t *variant, const epf_params_t *params)
{
    const fixed_format_t *format = variant->format;
    return (epf_lsb_t){.x = params->f_max / params->sigma_0 / format->z_max_counts,
                       .v = params->v_s / format->v_s_counts,
                       .f = params->f_max / format->z_max_counts,
                       .t = format->tick};
}

static epf_status_t start(estimator_t *estimator, const epf_params_t *params, const epf_lsb_t *lsb)
{
    const fixed_format_t *format = estimator->variant->format;
    estimator_fixed_t *const fixed = &estimator->as.fixed;
    *fixed = (estimator_fixed_t){.lsb = *lsb};
    const epf_status_t status = format->start(&fixed->integers, params, lsb);
    if (status == EPF_OK) {
        fixed->z_shift = format->z_shift(&fixed->integers);
    }
    return status;
}

/* ---- from SI units to integers --------------------------------------------------------------- */

/* Whole counts. Beyond 2^53 a double could not tell one from the next. */
static double counts(double x, float lsb)
{
    const double most = 9007199254740992.0;
    return saturate(round(x / (double)lsb), -most, most);
}

/* How far a counter has come, which it then shows. The difference of counts, not the count of a
   difference: rounding errors do not add up. */
static double advanced(double *counter, double now)
{
    const double difference = now - *counter;
    *counter = now;
    return difference;
}

/* A signal as its integer can hold it */
static double clipped(estimator_fixed_t *fixed, double x, double least, double most)
{
    const double fitting = saturate(x, least, most);
    fixed->clipped += fitting != x;
    return fitting;
}

static void step(estimator_t *estimator, const motion_t *motion)
{
    const fixed_format_t *format = estimator->variant->format;
    estimator_fixed_t *const fixed = &estimator->as.fixed;
    const double dx = advanced(&fixed->x_counts, counts(motion->end_x, fixed->lsb.x));
    const double dt = advanced(&fixed->t_counts, counts(motion->end_t, fixed->lsb.t));
    const double v = counts(motion->v, fixed->lsb.v);
    const double most = (double)format->signal_max;

    fixed->force = format->step(&fixed->integers, (int32_t)clipped(fixed, dx, -most, most),
                                (int32_t)clipped(fixed, v, -most, most),
                                (uint32_t)clipped(fixed, dt, 0.0, (double)format->dt_max));
}

/* ---- and back -------------------------------------------------------------------------------- */

static estimate_t estimate(const estimator_t *estimator)
{
    const estimator_fixed_t *fixed = &estimator->as.fixed;
    const fixed_format_t *format = estimator->variant->format;
    const double z = (double)format->z(&fixed->integers);
    return (estimate_t){ldexp(z * (double)fixed->lsb.x, -fixed->z_shift),
                        fixed->force * (double)fixed->lsb.f, format->rejected(&fixed->integers)};
}

const variant_t variant_q31 = {"q31", &q31_format, start, step, estimate};
const variant_t variant_q15 = {"q15", &q15_format, start, step, estimate};
