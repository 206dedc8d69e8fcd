/* SPDX-License-Identifier: MIT */
/* Includes the source itself: the internal force is nobody's business but the theorems'. */
#include "../../src/q31.c" /* NOLINT(bugprone-suspicious-include) */

#include "fixed_variant.h"

static int64_t internal_force(const epf_fixed_t *ep, uint32_t dt)
{
    const uint32_t damped = dt != 0 ? damping(ep->coeffs, ep->dz, dt) : 0;
    return ep->z + 256 * (int64_t)rest_of_force(ep, published_point(ep)->viscous, damped);
}

const fixed_variant_t q31_variant = {
    .name = "q31",
    .signal_max = INT32_MAX,
    .time_max = UINT32_MAX,
    .accuracy = 1e-5,
    .coeffs_init = epf_q31_coeffs_init,
    .init = epf_q31_init,
    .reset = epf_q31_reset,
    .set_velocity = epf_q31_set_velocity,
    .advance = epf_q31_advance,
    .force = epf_q31_force,
    .step = epf_q31_step,
    .output = epf_q31_output,
    .fss = epf_q31_fss,
    .alpha = epf_q31_alpha,
    .internal_force = internal_force,
};
