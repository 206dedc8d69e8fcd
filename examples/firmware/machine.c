/* SPDX-License-Identifier: MIT */
#include "machine.h"

#include "board.h"

#define TIMEOUT 100u /* ticks without a count: an event of none, so that the damping term ends */

/* Speeds are in 2^-12 counts per tick: 4096 is the Stribeck velocity */
typedef struct {
    uint16_t ticks;
    int16_t speed;     /* at the beginning */
    int16_t slope;     /* what is added to it with each tick */
    uint16_t reversal; /* ticks after which it turns its sign, again and again; 0: never */
} segment_t;

static const segment_t motion[] = {
    /* slow reversals, with dwells */
    {1000, 820, 0, 0},
    {300, 0, 0, 0},
    {1000, -820, 0, 0},
    {300, 0, 0, 0},
    {1000, 820, 0, 0},
    {300, 0, 0, 0},
    /* through the Stribeck velocity, and back */
    {1024, 0, 16, 0},
    {1024, 16384, -16, 0},
    {1024, 0, -16, 0},
    {1024, -16384, 16, 0},
    {300, 0, 0, 0},
    /* tremor */
    {1200, 820, 0, 30},
};
#define SEGMENTS (sizeof motion / sizeof motion[0])

static uint8_t segment;
static uint16_t tick; /* of the segment */
static int16_t speed;
static int32_t travel; /* 2^-12 counts beyond the last count */
static encoder_event_t event;

bool machine_has_stopped(void)
{
    return segment == SEGMENTS;
}

static void accelerate(void)
{
    const segment_t *now = &motion[segment];
    if (tick == 0) {
        speed = now->speed;
    } else if (now->reversal != 0 && tick % now->reversal == 0) {
        speed = (int16_t)-speed;
    }
    speed = (int16_t)(speed + now->slope);
    tick++;
    if (tick == now->ticks) {
        tick = 0;
        segment++;
    }
}

/* Whole counts, towards zero */
static int16_t counts(void)
{
    travel += speed;
    const int16_t whole = (int16_t)(travel / 4096);
    travel %= 4096;
    return whole;
}

void machine_tick(void)
{
    if (machine_has_stopped()) {
        return;
    }
    accelerate();
    event.dx = counts();
    event.dt++;
    if (event.dx != 0 || event.dt == TIMEOUT) {
        board_pend_encoder(); /* the last act: it takes the event at once */
    }
}

encoder_event_t machine_encoder(void)
{
    const encoder_event_t taken = event;
    event = (encoder_event_t){0, 0};
    return taken;
}
