/* SPDX-License-Identifier: MIT */
#include "noise.h"

/* splitmix64 of S. Vigna: every seed is a good one */
static uint64_t next_word(noise_t *noise)
{
    noise->state += UINT64_C(0x9e3779b97f4a7c15);
    uint64_t w = noise->state;
    w = (w ^ (w >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    w = (w ^ (w >> 27)) * UINT64_C(0x94d049bb133111eb);
    return w ^ (w >> 31);
}

double noise_next(noise_t *noise)
{
    return (double)(next_word(noise) >> 11) / 4503599627370496.0 - 1.0; /* 53 bits over 2^52 */
}
