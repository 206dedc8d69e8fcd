/* SPDX-License-Identifier: MIT */
#include "coefficients.h"

#include "tables.h"
#include "variant.h"

coefficients_t coefficients_of(const friction_t *friction)
{
    const epf_params_t params = params_of(friction, EPF_UPDATE_MEAN_VALUE);
    coefficients_t made = {.lsb_q31 = variant_default_lsb(&variant_q31, &params),
                           .lsb_q15 = variant_default_lsb(&variant_q15, &params)};
    (void)epf_f32_coeffs_init(&made.f32, &params);
    (void)epf_q31_coeffs_init(&made.q31, &params, &made.lsb_q31);
    (void)epf_q15_coeffs_init(&made.q15, &params, &made.lsb_q15);
    return made;
}
