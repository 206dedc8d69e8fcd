/* SPDX-License-Identifier: MIT */
/* Compiled by bad_constants.cmake, which defines TYPE and COEFFS. */
#include "epf/epf.h"

extern const TYPE coeffs;
const TYPE coeffs = COEFFS;
