/* SPDX-License-Identifier: MIT */
/* Includes the source itself: the terms of the force are nobody's business but the theorems'. */
#include "../../src/q15.c" /* NOLINT(bugprone-suspicious-include) */

#include <stdbool.h>

static bool same_gains(const coeffs_t *a, const coeffs_t *b)
{
    return a->ratio == b->ratio && a->ratio_limit == b->ratio_limit && a->viscous == b->viscous &&
           a->viscous_limit == b->viscous_limit && a->viscous_shift == b->viscous_shift;
}

static bool same_span(const point_t *a, const point_t *b)
{
    return a->span_shift == b->span_shift;
}

#define MEMBER q15
#include "fixed_variant_functions.h"

const fixed_variant_t q15_variant = {
    .name = "q15",
    .signal_max = INT16_MAX,
    .time_max = UINT16_MAX,
    .accuracy = {1e-3, 1e-3},
    .ripple = {0, 131072}, /* 2.5e-4 z_max at the most */
    VARIANT_FUNCTIONS,
};
