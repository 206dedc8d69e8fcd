/* SPDX-License-Identifier: MIT */
/* The variant in single precision: SI units throughout. */
#include "saturate.h"
#include "variant.h"

#include <stddef.h>

static epf_status_t start(estimator_t *estimator, const epf_params_t *params, const epf_lsb_t *lsb)
{
    (void)lsb;
    estimator_f32_t *const f32 = &estimator->as.f32;
    const epf_status_t status = epf_f32_coeffs_init(&f32->coeffs, params);
    if (status == EPF_OK) {
        epf_f32_init(&f32->contact, &f32->coeffs);
    }
    return status;
}

static void step(estimator_t *estimator, const motion_t *motion)
{
    (void)epf_f32_step(&estimator->as.f32.contact, saturate_float(motion->dx),
                       saturate_float(motion->v), saturate_float(motion->dt));
}

static estimate_t estimate(const estimator_t *estimator)
{
    const epf_f32_t *contact = &estimator->as.f32.contact;
    return (estimate_t){(double)epf_f32_z(contact), (double)epf_f32_output(contact),
                        contact->rejected};
}

const variant_t variant_f32 = {"f32", NULL, start, step, estimate};
