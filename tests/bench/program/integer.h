/* SPDX-License-Identifier: MIT */
/* SI units as integers that saturate, as firmware would have them. */
#ifndef INTEGER_H
#define INTEGER_H

#include <math.h>
#include <stdint.h>

static inline int32_t to_signed(float counts, int32_t least, int32_t most)
{
    if (counts >= (float)most) {
        return most;
    }
    return counts > (float)least ? (int32_t)counts : least; /* NaN: as far as it can be wrong */
}

/* The same, but never 0 for what is not 0 */
static inline int32_t to_signal(float counts, int32_t least, int32_t most)
{
    if (fabsf(counts) < 1.0f && counts != 0.0f) {
        return counts < 0.0f ? -1 : 1;
    }
    return to_signed(counts, least, most);
}

static inline uint32_t to_ticks(float counts, uint32_t most)
{
    if (counts >= (float)most) {
        return most;
    }
    return counts >= 1.0f ? (uint32_t)counts : counts > 0.0f ? 1u : 0u;
}

static inline int32_t to_deflection(float counts, uint8_t z_shift)
{
    return to_signed(counts * (float)(UINT32_C(1) << z_shift), INT32_MIN, INT32_MAX);
}

#endif
