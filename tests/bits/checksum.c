/* SPDX-License-Identifier: MIT */
#include "checksum.h"

#include <string.h>

uint32_t checksum_add(uint32_t checksum, uint32_t word)
{
    for (int i = 0; i < 4; i++) {
        checksum = (checksum ^ (word & 0xffu)) * 16777619u;
        word >>= 8;
    }
    return checksum;
}

uint32_t checksum_add_signed(uint32_t checksum, int32_t x)
{
    return checksum_add(checksum, (uint32_t)x);
}

uint32_t checksum_add_float(uint32_t checksum, float x)
{
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return checksum_add(checksum, bits);
}
