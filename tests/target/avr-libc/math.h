/* SPDX-License-Identifier: MIT */
/*
 * What <math.h> of C99 has and that of avr-libc lacks, or gives the type double, which there is float
 * by another name. For the tests only; the library needs no libm.
 */
#ifndef EPF_TESTS_AVR_MATH_H
#define EPF_TESTS_AVR_MATH_H

#include_next <math.h>

#include <stdint.h>

#undef INFINITY
#undef NAN
#undef fabsf
#undef fmaxf
#undef fminf
#undef powf
#define INFINITY __builtin_inff()
#define NAN      __builtin_nanf("")

static inline float fabsf(float x)
{
    return (float)fabs((double)x);
}

static inline float fmaxf(float x, float y)
{
    return (float)fmax((double)x, (double)y);
}

static inline float fminf(float x, float y)
{
    return (float)fmin((double)x, (double)y);
}

static inline float powf(float x, float y)
{
    return (float)pow((double)x, (double)y);
}

/* To the even one of two that are equally near */
static inline double rint(double x)
{
    const double nearest = round(x);
    const int tie = fabs(nearest - x) == 0.5;
    return tie ? 2.0 * round(x / 2.0) : nearest;
}

/* For positive x, and y on either side of it */
static inline float nextafterf(float x, float y)
{
    union {
        float value;
        uint32_t bits;
    } next = {x};
    next.bits = y > x ? next.bits + 1 : next.bits - 1;
    return next.value;
}

#endif
