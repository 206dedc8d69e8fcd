/* SPDX-License-Identifier: MIT */
/*
 * Signs and leading zeros, for both fixed-point variants. No division, no 64-bit arithmetic.
 *
 * Comments that begin with an at sign, here and in the other files, are contracts in ACSL. Frama-C
 * proves them on this text, see tests/proof.
 */
#ifndef EPF_NUMBERS_H
#define EPF_NUMBERS_H

#include "compiler.h"

#include <stdint.h>

/* |x|, also of the most negative number */
/*@ assigns \nothing;
    ensures x >= 0 ==> \result == x;
    ensures x < 0 ==> \result == -x;
*/
static inline uint32_t magnitude(int32_t x)
{
    return x < 0 ? (uint32_t)(-(x + 1)) + 1u : (uint32_t)x;
}

/* The direction of x: 1, 0 or -1 */
/*@ assigns \nothing;
    ensures x > 0 ==> \result == 1;
    ensures x == 0 ==> \result == 0;
    ensures x < 0 ==> \result == -1;
*/
static inline int32_t sign(int32_t x)
{
    return x < 0 ? -1 : x != 0;
}

/* x as seen in the direction s, which is 1 or -1; 0 where s is 0 */
/*@ requires -1 <= s <= 1 && -2147483647 <= x;
    assigns \nothing;
    ensures \result == s * x;
*/
static inline int32_t along(int32_t s, int32_t x)
{
#ifdef __AVR__ /* where a product is long */
    return s < 0 ? -x : s == 0 ? 0 : x;
#else
    return s * x;
#endif
}

/* How far x can be moved up until its highest bit is the 32nd, which is one of the upper 16 now */
/*@ requires 65536 <= x;
    assigns \nothing;
    ensures 0 <= \result <= 15;
    ensures 1048576 <= x ==> \result <= 11;
    ensures 16777216 <= x ==> \result <= 7;
    ensures x < 2147483648 ==> 1 <= \result;
    ensures x < 1073741824 ==> 2 <= \result;
*/
static inline int leading_zeros_16(uint32_t x)
{
#ifdef __ARM_FEATURE_CLZ /* one instruction; a test compares the two on the cores that have it */
    return __builtin_clz(x);
#else
    int zeros = 0;
    if (x / 0x1000000u == 0) {
        x *= 0x100u;
        zeros += 8;
    }
    if (x / 0x10000000u == 0) {
        x *= 0x10u;
        zeros += 4;
    }
    if (x / 0x40000000u == 0) {
        x *= 4u;
        zeros += 2;
    }
    return x / 0x80000000u == 0 ? zeros + 1 : zeros;
#endif
}

/* The same for any x > 0 */
/*@ requires 0 < x;
    assigns \nothing;
    ensures 0 <= \result <= 31;
    ensures 256 <= x ==> \result <= 23;
    ensures x < 2147483648 ==> 1 <= \result;
    ensures x < 1073741824 ==> 2 <= \result;
*/
static inline int leading_zeros(uint32_t x)
{
#ifdef __ARM_FEATURE_CLZ
    return __builtin_clz(x);
#else
    return x / 0x10000u == 0 ? 16 + leading_zeros_16(x * 0x10000u) : leading_zeros_16(x);
#endif
}

/* floor(x 2^-shift) */
/*@ requires 0 <= shift <= 31;
    assigns \nothing;
    ensures x == 0 ==> \result == 0;
*/
static inline uint32_t shifted_down(uint32_t x, int shift)
{
#ifdef __AVR__ /* it shifts bit by bit, but whole bytes at once */
    if (shift >= 16) {
        x >>= 16;
        shift -= 16;
    }
    if (shift >= 8) {
        x >>= 8;
        shift -= 8;
    }
#endif
    return x >> shift;
}

#endif
