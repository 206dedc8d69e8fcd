/* SPDX-License-Identifier: MIT */
/*
 * The friction of the slide, as this firmware uses it. friction_f32.c, friction_q31.c and
 * friction_q15.c are the same in the three variants of the library, and all that calls it.
 */
#ifndef FRICTION_H
#define FRICTION_H

#include <stdint.h>

/* Before the interrupts are enabled */
void friction_start(void);

/* Encoder interrupt: dx counts */
void friction_advance(int16_t dx);

/* Encoder interrupt: the force after the last friction_advance, which took dt ticks */
void friction_publish(uint16_t dt);

/* Control interrupt: the velocity. It and the encoder interrupt may preempt each other, in whatever
   order of priority; but friction_speed no more than once within one friction_advance, or within one
   friction_publish. */
void friction_speed(int16_t v);

/* Anywhere: the force in units of FORCE */
int32_t friction_force(void);

/* Encoder interrupt: all bits of z and of the force, folded into a digest of those before */
uint32_t friction_digest(uint32_t digest);

static inline uint32_t fold(uint32_t digest, uint32_t word)
{
    return (digest ^ word) * UINT32_C(16777619); /* FNV-1a, by words */
}

#endif
