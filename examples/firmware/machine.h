/* SPDX-License-Identifier: MIT */
/*
 * Stands for the machine, its encoder and its clock: a motion made of integers, the same on every
 * core. On a real board nothing of this remains.
 */
#ifndef MACHINE_H
#define MACHINE_H

#include <stdbool.h>
#include <stdint.h>

/* What the encoder interrupt reads from the registers of a counter and a timer */
typedef struct {
    int16_t dx;  /* counts since the last interrupt */
    uint16_t dt; /* ticks since then */
} encoder_event_t;

/* One tick passes: pends the encoder interrupt if a count or the timeout has come */
void machine_tick(void);

bool machine_has_stopped(void);

encoder_event_t machine_encoder(void);

#endif
