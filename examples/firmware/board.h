/* SPDX-License-Identifier: MIT */
/*
 * What a core gives the firmware: cortex_m.c, avr.c, or host.c, where an interrupt is a call. The
 * encoder interrupt preempts the control interrupt, and that the main loop.
 */
#ifndef BOARD_H
#define BOARD_H

#include <stdbool.h>
#include <stdint.h>

/* Defined by the firmware, called by the vectors */
void encoder_interrupt(void);
void control_interrupt(void);

/* Enables the interrupts */
void board_start(void);

/* Taken before the call returns, unless an interrupt of the same priority is active */
void board_pend_encoder(void);
void board_pend_control(void);

/* The encoder interrupt, once, so many clocks from now; not on the host */
void board_pend_encoder_after(uint16_t clocks);

void board_put(char c);

/* Prints what memory has been used; false if there was no end to it */
bool board_report(void);

#endif
