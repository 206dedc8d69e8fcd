/* SPDX-License-Identifier: MIT */
/*
 * A mass on a contact, driven by a force, integrated over time:
 *
 *     dx/dt = v        m dv/dt = F(t) - f        dz/dt by the contact
 *
 * by the classical Runge-Kutta method of fourth order at a fixed step. A run integrates everything twice,
 * at its step and at half of it, and reports how far the two came apart. The error of the finer motion
 * is about a fifteenth of that where the motion is smooth, and less than all of it where alpha has its kinks.
 */
#ifndef PLANT_SLIDE_H
#define PLANT_SLIDE_H

#include "contact.h"

typedef struct {
    double x, v, z; /* position, m; velocity, m/s; deflection of the contact, m */
} slide_state_t;

typedef struct {
    contact_t contact;
    double mass;                                         /* kg; HUGE_VAL: v never changes */
    double (*force)(const void *context, double time_s); /* F(t), N; may be null: none */
    const void *context;                                 /* handed to it */
} slide_t;

/* The friction that the mass feels, N. Coulomb friction at rest is what holds the mass, up to f_c. */
double slide_friction(const slide_t *slide, const slide_state_t *motion, double time);

/* The motion one step later */
slide_state_t slide_step(const slide_t *slide, slide_state_t motion, double time, double step);

/* Both motions of a run: at its step, and at half of it */
typedef struct {
    const slide_t *slide; /* must outlive the run */
    double rate;          /* coarse steps per second */
    long steps;           /* coarse steps done */
    slide_state_t coarse, fine;
    slide_state_t
        apart; /* the largest differences between the two, absolute, after any coarse step */
} run_t;

run_t run_from(const slide_t *slide, slide_state_t start, double rate);

/* Time is counted, not summed: it has no rounding drift */
double run_time(const run_t *run);

void run_advance(run_t *run, long steps);

/*
 * The coarse motion starts again from the fine one, so that `apart` is the largest error of one advance, not of
 * the whole run. A controller calls it before each advance: a command computed from the fine motion closes no loop
 * around the coarse one, which would run away.
 */
void run_rejoin(run_t *run);

#endif
