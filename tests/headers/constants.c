/* SPDX-License-Identifier: MIT */
/* Compiled by bad_constants.cmake, which defines COEFFS. */
#include "epf/epf.h"

extern const epf_f32_coeffs_t coeffs;
const epf_f32_coeffs_t coeffs = COEFFS;
