/* SPDX-License-Identifier: MIT */
#include "variant.h"

#include <stddef.h>
#include <string.h>

const variant_t *variant_find(const char *name)
{
    static const variant_t *const all[] = {&variant_f32, &variant_q31, &variant_q15};
    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) {
        if (strcmp(name, all[i]->name) == 0) {
            return all[i];
        }
    }
    return NULL;
}

epf_status_t estimator_start(estimator_t *estimator, const variant_t *variant,
                             const epf_params_t *params, const epf_lsb_t *lsb)
{
    *estimator = (estimator_t){.variant = variant};
    return variant->start(estimator, params, lsb);
}

void estimator_step(estimator_t *estimator, const motion_t *motion)
{
    estimator->variant->step(estimator, motion);
}

estimate_t estimator_estimate(const estimator_t *estimator)
{
    return estimator->variant->estimate(estimator);
}
