/* SPDX-License-Identifier: MIT */
/*
 * Is anything ever seen half-written? An alarm lets the encoder interrupt preempt the control
 * interrupt after 1, 2, 3, ... clocks, until it comes too late: at every instruction. What comes
 * out must be, bit for bit, what comes out without interruption before or after that instruction.
 */
#include "board.h"
#include "friction.h"
#include "print.h"

#include <stddef.h>

/* In units of SPEED, each with an operating point of its own. There are two places: that which gets
   the new point holds the stale one, so half of each would be neither the old nor the new. The two
   differ in every member, also in the bits that z_ss and z_ss - z_ba have. */
enum { STALE = 30, OLD = 100, NEW = 300 };

/* An experiment: what the control interrupt does, what the encoder interrupt does meanwhile, and
   what one of the two sees */
typedef struct {
    const char *name;
    uint32_t (*control)(void);
    uint32_t (*encoder)(void);
    bool encoder_sees;
} experiment_t;

static uint32_t set_velocity(void)
{
    friction_speed(NEW);
    return 0;
}

/* A step within the mixed region, by all of the operating point but z_ss; then a leap, which ends
   in that */
static uint32_t move(void)
{
    friction_moved(5, 1);
    const uint32_t digest = friction_digest(0);
    friction_moved(400, 1);
    return friction_digest(digest);
}

static uint32_t read_force(void)
{
    return (uint32_t)friction_force();
}

static uint32_t reverse(void)
{
    friction_moved(-400, 1);
    return 0;
}

static const experiment_t experiments[] = {
    {"set_velocity", set_velocity, move, true},
    {"output", read_force, reverse, false},
};

static const experiment_t *experiment;
static volatile bool active;         /* the control interrupt is */
static volatile bool fired, in_time; /* the encoder interrupt has, and while the other was active */
static volatile uint32_t seen;

void control_interrupt(void)
{
    active = true;
    const uint32_t outcome = experiment->control();
    active = false;
    if (!experiment->encoder_sees) {
        seen = outcome;
    }
}

void encoder_interrupt(void)
{
    in_time = active;
    const uint32_t outcome = experiment->encoder();
    if (experiment->encoder_sees) {
        seen = outcome;
    }
    fired = true;
}

/* The same state each time, in the mixed region; either of the two places may be the next */
static void prepare(bool other_place)
{
    friction_start();
    if (other_place) {
        friction_speed(0);
    }
    friction_speed(STALE);
    friction_speed(OLD);
    friction_moved(90, 10);
    fired = false;
}

static uint32_t without_preemption(bool other_place, bool encoder_first)
{
    prepare(other_place);
    if (encoder_first) {
        board_pend_encoder();
    }
    board_pend_control();
    if (!encoder_first) {
        board_pend_encoder();
    }
    return seen;
}

static void preempt_after(uint16_t clocks, bool other_place)
{
    prepare(other_place);
    board_pend_encoder_after(clocks);
    board_pend_control();
    while (!fired) {
    }
}

/* As if the encoder interrupt had come before the control interrupt, after it, or neither */
typedef struct {
    uint16_t before, after, torn;
} count_t;

static void count_one(count_t *count, uint32_t before, uint32_t after)
{
    if (seen == before) {
        count->before++;
    } else if (seen == after) {
        count->after++;
    } else {
        count->torn++;
    }
}

static count_t sweep(bool other_place)
{
    const uint32_t before = without_preemption(other_place, true);
    const uint32_t after = without_preemption(other_place, false);
    count_t count = {0, 0, 0};
    bool begun = false; /* the first alarms come before the control interrupt */
    for (uint16_t clocks = 1; in_time || !begun; clocks++) {
        preempt_after(clocks, other_place);
        if (in_time) {
            begun = true;
            count_one(&count, before, after);
        }
    }
    return count;
}

static void print_count(const char *what, uint16_t count)
{
    print_text(what);
    print_number(count);
}

/* Both outcomes must have been seen, or the sweep has missed the moment between them */
static bool is_whole(bool other_place)
{
    const count_t count = sweep(other_place);
    print_text(experiment->name);
    print_count(": before ", count.before);
    print_count(", after ", count.after);
    print_count(", torn ", count.torn);
    print_text("\n");
    return count.before != 0 && count.after != 0 && count.torn == 0;
}

int main(void)
{
    bool whole = true;
    board_start();
    for (size_t i = 0; i < sizeof experiments / sizeof experiments[0]; i++) {
        experiment = &experiments[i];
        whole = is_whole(false) && whole;
        whole = is_whole(true) && whole;
    }
    return whole ? 0 : 1;
}
