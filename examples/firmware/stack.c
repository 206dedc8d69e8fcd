/* SPDX-License-Identifier: MIT */
#include "stack.h"

#include "print.h"

#include <stdint.h>

#define PAINTED 1024u
#define MARGIN  64u /* of this function itself */
#define COLOUR  0xc5u

/* Of the linker scripts of picolibc and avr-libc alike */
extern uint8_t __data_start[], __heap_start[], __stack[];

#ifdef __AVR__
#define STACK_TOP (__stack + 1) /* there it is the last byte, not the first beyond */
#else
#define STACK_TOP __stack
#endif

static volatile uint8_t *lowest;

void stack_paint(volatile uint8_t *pointer)
{
    lowest = pointer - MARGIN - PAINTED;
    for (uint16_t i = 0; i < PAINTED; i++) {
        lowest[i] = COLOUR;
    }
}

static void print_bytes(const char *what, intptr_t bytes)
{
    print_text(what);
    print_number((int32_t)bytes);
    print_text(" bytes\n");
}

bool stack_report(void)
{
    uint16_t unused = 0;
    while (unused < PAINTED && lowest[unused] == COLOUR) {
        unused++;
    }
    const volatile uint8_t *deepest = lowest + unused;
    print_bytes("stack       ", STACK_TOP - deepest);
    print_bytes("static data ", __heap_start - __data_start);
    print_bytes("free        ", deepest - __heap_start);
    return unused != 0;
}
