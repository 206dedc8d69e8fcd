/* SPDX-License-Identifier: MIT */
/*
 * Around what an interrupt writes and another context reads. A core that loads a word at once needs
 * nothing. An 8-bit core loads it byte by byte, and an interrupt between two of them leaves the
 * reader with half of the old force and half of the new one: there the interrupts wait meanwhile.
 */
#ifndef GUARD_H
#define GUARD_H

#include <stdint.h>

typedef uint8_t guard_t;

#if defined(__AVR__) && !defined(UNGUARDED) /* a test leaves it out, to see what then happens */

#include <avr/interrupt.h>
#include <avr/io.h>

static inline guard_t guard_enter(void)
{
    const guard_t status = SREG;
    cli();
    return status;
}

static inline void guard_leave(guard_t status)
{
    SREG = status; /* enabled again, where they were before */
}

#else

static inline guard_t guard_enter(void)
{
    return 0;
}

static inline void guard_leave(guard_t guard)
{
    (void)guard;
}

#endif

#endif
