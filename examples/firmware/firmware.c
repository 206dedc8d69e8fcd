/* SPDX-License-Identifier: MIT */
/*
 * The firmware: an encoder interrupt, a control interrupt and a main loop that share one estimator
 * without locks. README.md says which call goes where, and why.
 */
#include "board.h"
#include "contact.h"
#include "friction.h"
#include "guard.h"
#include "machine.h"
#include "print.h"

#define PRINTED_MS 20

static volatile uint16_t position; /* counts; wraps */
static volatile int32_t command;   /* what the controller gives the motor, in units of FORCE */

/* Evidence, read where the machine stands still and no interrupt can come */
static volatile bool in_control;
static volatile uint16_t events, preemptions;
static volatile uint32_t digest;

void encoder_interrupt(void)
{
    const encoder_event_t event = machine_encoder();
    friction_advance(event.dx);
    friction_publish(event.dt); /* of the state that friction_advance leaves: never apart from it */
    position = (uint16_t)(position + (uint16_t)event.dx);

    digest = friction_digest(digest);
    events++;
    if (in_control) {
        preemptions++;
    }
}

static uint16_t position_now(void)
{
    const guard_t guard = guard_enter();
    const uint16_t now = position;
    guard_leave(guard);
    return now;
}

static int32_t command_now(void)
{
    const guard_t guard = guard_enter();
    const int32_t now = command;
    guard_leave(guard);
    return now;
}

/* The encoder interrupt may come anywhere in here: machine_tick() makes sure that it does */
void control_interrupt(void)
{
    static uint16_t last;
    in_control = true;

    const uint16_t now = position_now();
    machine_tick();
    friction_speed((int16_t)((int16_t)(now - last) * SPEED_OF_COUNT));
    machine_tick();
    command = friction_force(); /* a controller would add its own output */
    last = now;

    in_control = false;
}

static void print_columns(uint16_t ms)
{
    print_number(ms);
    print_text(" ");
    print_number((int16_t)position_now());
    print_text(" ");
    print_number(command_now());
    print_text(" ");
    print_number(friction_force());
    print_text(" ");
    print_bits(digest);
    print_text("\n");
}

int main(void)
{
    friction_start();
    board_start(); /* from here on they interrupt */

    print_text("ms position command force digest\n");
    for (uint16_t ms = 0; !machine_has_stopped(); ms += CONTROL_MS) {
        board_pend_control();
        for (uint8_t tick = 2; tick < TICKS_PER_CONTROL; tick++) { /* 2 pass in the interrupt */
            machine_tick();
        }
        if (ms % PRINTED_MS == 0) {
            print_columns(ms);
        }
    }
    print_text("encoder events       ");
    print_number(events);
    print_text("\nof them preemptions  ");
    print_number(preemptions);
    print_text("\n");
    return board_report() ? 0 : 1;
}
