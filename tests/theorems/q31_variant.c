/* SPDX-License-Identifier: MIT */
/* Includes the source itself: the terms of the force are nobody's business but the theorems'. */
#include "../../src/q31.c" /* NOLINT(bugprone-suspicious-include) */

#include <stdbool.h>

static bool same_gain(epf_q31_gain_t a, epf_q31_gain_t b)
{
    return a.mantissa == b.mantissa && a.limit == b.limit && a.up == b.up;
}

static bool same_gains(const coeffs_t *a, const coeffs_t *b)
{
    return same_gain(a->ratio, b->ratio) && same_gain(a->viscous, b->viscous);
}

static bool same_span(const point_t *a, const point_t *b)
{
    return a->span_zeros == b->span_zeros;
}

#define MEMBER q31
#include "fixed_variant_functions.h"

const fixed_variant_t q31_variant = {
    .name = "q31",
    .signal_max = INT32_MAX,
    .time_max = UINT32_MAX,
    .accuracy = {3e-6, 1e-5},
    .ripple = {0, 8},
    VARIANT_FUNCTIONS,
};
