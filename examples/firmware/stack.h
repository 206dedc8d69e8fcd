/* SPDX-License-Identifier: MIT */
/* How much RAM the firmware has used: what it does not use of the painted stack keeps its colour. */
#ifndef STACK_H
#define STACK_H

#include <stdbool.h>
#include <stdint.h>

/* At start-up: paints below the stack pointer */
void stack_paint(volatile uint8_t *pointer);

/* Prints stack, static data and what is left; false if no paint is left */
bool stack_report(void);

#endif
