/* SPDX-License-Identifier: MIT */
/* Random numbers from integer arithmetic alone: the same on every core, whatever its floats are. */
#ifndef EPF_TESTS_INTEGERS_H
#define EPF_TESTS_INTEGERS_H

#include <stdint.h>

/* xorshift32, Marsaglia; *state must not be 0 */
static inline uint32_t random_word(uint32_t *state)
{
    *state ^= *state << 13;
    *state ^= *state >> 17;
    *state ^= *state << 5;
    return *state;
}

static inline uint32_t random_below(uint32_t *state, uint32_t bound)
{
    return random_word(state) % bound;
}

/* Where the motion goes at sample i: stretches one way, the other way, and to and fro */
static inline int random_direction(uint32_t *state, unsigned i)
{
    switch (i / 64 % 4) {
    case 0:
        return 1;
    case 1:
        return -1;
    default:
        return random_below(state, 2) != 0 ? 1 : -1;
    }
}

#endif
