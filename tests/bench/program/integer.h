/* SPDX-License-Identifier: MIT */
/* SI units as integers that saturate, as firmware would have them. */
#ifndef INTEGER_H
#define INTEGER_H

#include "contact.h"

#include <math.h>
#include <stdint.h>

static inline int32_t to_signed(float counts, int32_t least, int32_t most)
{
    if (counts >= (float)most) {
        return most;
    }
    return counts > (float)least ? (int32_t)counts : least; /* NaN: as far as it can be wrong */
}

static inline uint32_t to_unsigned(float counts, uint32_t most)
{
    if (counts >= (float)most) {
        return most;
    }
    return counts > 0.0f ? (uint32_t)counts : 0;
}

static inline int32_t to_deflection(float si, uint8_t z_shift)
{
    return to_signed(ldexpf(si / LSB_X, z_shift), INT32_MIN, INT32_MAX);
}

#endif
