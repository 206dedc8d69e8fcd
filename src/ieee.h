/* SPDX-License-Identifier: MIT */
/* What the sources that compute with floats demand of them, so that all cores come to the same bits. */
#ifndef EPF_IEEE_H
#define EPF_IEEE_H

#include <float.h>

#if FLT_RADIX != 2 || FLT_MANT_DIG != 24 || FLT_MAX_EXP != 128
#error "epf needs float to be IEEE 754 binary32"
#endif
#if FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 16 /* 16: only half precision is widened */
#error "epf needs float expressions to be evaluated in float (on 32-bit x86: -mfpmath=sse)"
#endif
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "epf needs IEEE arithmetic: compile this file without -ffast-math and its parts"
#endif
#ifdef __clang__
#pragma STDC FP_CONTRACT OFF /* gcc: -ffp-contract=off, or -std=c99 */
#if __clang_major__ >= 11 /* no macro tells of -fassociative-math, which would undo the two-sum */
#pragma clang fp reassociate(off)
#endif
#endif

#endif
