/* SPDX-License-Identifier: MIT */
/* Includes the source itself: the internal force is nobody's business but the theorems'. */
#include "../../src/q15.c" /* NOLINT(bugprone-suspicious-include) */

#include "fixed_variant.h"

static void set_velocity(epf_fixed_t *ep, int32_t v)
{
    epf_q15_set_velocity(ep, (int16_t)v);
}

static int32_t advance(epf_fixed_t *ep, int32_t dx)
{
    return epf_q15_advance(ep, (int16_t)dx);
}

static int32_t force(epf_fixed_t *ep, uint32_t dt)
{
    return epf_q15_force(ep, (uint16_t)dt);
}

static int32_t step(epf_fixed_t *ep, int32_t dx, int32_t v, uint32_t dt)
{
    return epf_q15_step(ep, (int16_t)dx, (int16_t)v, (uint16_t)dt);
}

static int32_t output(const epf_fixed_t *ep)
{
    return epf_q15_output(ep);
}

static int32_t fss(const epf_fixed_coeffs_t *c, int32_t v)
{
    return epf_q15_fss(c, (int16_t)v);
}

static int32_t alpha(const epf_fixed_coeffs_t *c, int32_t z, int32_t v)
{
    return epf_q15_alpha(c, z, (int16_t)v);
}

static int64_t internal_force(const epf_fixed_t *ep, uint32_t dt)
{
    const uint32_t damped = dt != 0 ? damping(ep->coeffs, ep->dz, (uint16_t)dt) : 0;
    return ep->z + 256 * (int64_t)rest_of_force(ep, published_point(ep)->viscous, damped);
}

const fixed_variant_t q15_variant = {
    .name = "q15",
    .signal_max = INT16_MAX,
    .time_max = UINT16_MAX,
    .accuracy = 2e-3,
    .coeffs_init = epf_q15_coeffs_init,
    .init = epf_q15_init,
    .reset = epf_q15_reset,
    .set_velocity = set_velocity,
    .advance = advance,
    .force = force,
    .step = step,
    .output = output,
    .fss = fss,
    .alpha = alpha,
    .internal_force = internal_force,
};
