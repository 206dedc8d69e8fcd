/* SPDX-License-Identifier: MIT */
/*
 * Is anything ever seen half-written? An alarm preempts the control interrupt after 1, 2, 3, ...
 * clocks, until it comes too late: at every instruction. What comes out must be, bit for bit, what
 * comes out without preemption before or after that instruction.
 */
#include "board.h"
#include "friction.h"
#include "print.h"

#include <stddef.h>

/* In units of SPEED. The new operating point is written over the stale one, while the old one is in
   use. It differs from both in every member, so that a mixture shows: in fixed point also in how many
   bits z_ss and z_ss - z_ba have, and in several bytes of the viscous term, which is all that force
   reads. */
enum { STALE = 30, OLD = 60, NEW = 290 };

/* Two contexts of the firmware: one is the control interrupt here, the other preempts it */
typedef struct {
    const char *name; /* of what is preempted */
    void (*preempted)(void);
    void (*preempting)(void);
} experiment_t;

/* What one of the two has seen meanwhile; 0 if all is in what they leave */
static volatile uint32_t seen;

static void set_velocity(void)
{
    friction_speed(NEW);
}

/* Two displacements within the mixed region. This one reaches neither z_ss, but with the old point it
   passes the new z_ss: it shows where only z_ss is new */
static void advance(void)
{
    friction_advance(25);
}

/* This one reaches z_ss with the new point, and not with the old: it shows where only z_ss is old */
static void advance_further(void)
{
    friction_advance(38);
}

/* A displacement that ends in z_ss */
static void leap(void)
{
    friction_advance(400);
}

static void force(void)
{
    friction_publish(1);
    seen = friction_digest(0);
}

static void move(void)
{
    advance();
    force();
    const uint32_t digest = seen;
    leap();
    force();
    seen = fold(digest, seen);
}

static void output(void)
{
    seen = (uint32_t)friction_force();
}

static void reverse(void)
{
    friction_advance(-400);
    friction_publish(1);
}

static const experiment_t experiments[] = {
    /* the displacement preempts the velocity, and a reader */
    {"set_velocity", set_velocity, move},
    {"output", output, reverse},
    /* the velocity preempts the displacement */
    {"advance", advance, set_velocity},
    {"advance further", advance_further, set_velocity},
    {"advance to z_ss", leap, set_velocity},
    {"force", force, set_velocity},
};

static const experiment_t *experiment;
static volatile bool active;         /* the control interrupt is */
static volatile bool fired, in_time; /* the alarm has, and while the other was active */

void control_interrupt(void)
{
    active = true;
    experiment->preempted();
    active = false;
}

void encoder_interrupt(void)
{
    in_time = active;
    experiment->preempting();
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
    friction_advance(90);
    friction_publish(10);
    seen = 0;
    fired = false;
}

/* What was seen and what is left: the state, and by the damping term its last change, whatever the
   velocity was */
static uint32_t outcome(void)
{
    friction_speed(OLD);
    friction_publish(1);
    return friction_digest(seen);
}

static uint32_t without_preemption(bool other_place, bool preempting_first)
{
    prepare(other_place);
    if (preempting_first) {
        board_pend_encoder();
    }
    board_pend_control();
    if (!preempting_first) {
        board_pend_encoder();
    }
    return outcome();
}

static uint32_t preempt_after(uint16_t clocks, bool other_place)
{
    prepare(other_place);
    board_pend_encoder_after(clocks);
    board_pend_control();
    while (!fired) {
    }
    return outcome();
}

/* As if what preempts had come before what it preempts, after it, or neither */
typedef struct {
    uint16_t before, after, torn;
} count_t;

static void count_one(count_t *count, uint32_t result, uint32_t before, uint32_t after)
{
    if (result == before) {
        count->before++;
    } else if (result == after) {
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
        const uint32_t result = preempt_after(clocks, other_place);
        if (in_time) {
            begun = true;
            count_one(&count, result, before, after);
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
