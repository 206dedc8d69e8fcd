/* SPDX-License-Identifier: MIT */
/* A program of one constant, in C or C++. Compiled by compile.cmake, which defines TYPE and COEFFS. */
#include "epf/epf.h"

#ifdef __cplusplus
extern const TYPE coeffs;
constexpr TYPE coeffs = COEFFS;
#else
extern const TYPE coeffs;
const TYPE coeffs = COEFFS;
#endif
