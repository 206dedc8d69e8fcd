/* SPDX-License-Identifier: MIT */
#include "slide.h"

#include "larger.h"

#include <math.h>
#include <stddef.h>

static double driving_force(const slide_t *slide, double time)
{
    return slide->force != NULL ? slide->force(slide->context, time) : 0.0;
}

static double sign(double a)
{
    return a > 0.0 ? 1.0 : a < 0.0 ? -1.0 : 0.0;
}

/* Where Coulomb friction lets the mass move: with its velocity, or where a force sets it off; else 0 */
static double direction_of(const slide_t *slide, const slide_state_t *m, double time)
{
    if (slide->contact.model != CONTACT_COULOMB || m->v != 0.0) {
        return sign(m->v);
    }
    const double force = driving_force(slide, time);
    return fabs(force) > slide->contact.friction.f_c ? sign(force) : 0.0;
}

/* In a given direction, which only Coulomb friction asks for */
static double friction(const slide_t *slide, const slide_state_t *m, double force, double direction)
{
    const friction_t *p = &slide->contact.friction;
    if (slide->contact.model != CONTACT_COULOMB) {
        return contact_force(&slide->contact, m->z, m->v);
    }
    return direction != 0.0 ? direction * p->f_c + p->sigma_2 * m->v : force;
}

double slide_friction(const slide_t *slide, const slide_state_t *motion, double time)
{
    return friction(slide, motion, driving_force(slide, time), direction_of(slide, motion, time));
}

static slide_state_t derivative(const slide_t *slide, slide_state_t m, double time,
                                double direction)
{
    const double force = driving_force(slide, time);
    return (slide_state_t){m.v, (force - friction(slide, &m, force, direction)) / slide->mass,
                           contact_rate(&slide->contact, m.z, m.v)};
}

/* a + h b */
static slide_state_t along(slide_state_t a, double h, slide_state_t b)
{
    return (slide_state_t){a.x + h * b.x, a.v + h * b.v, a.z + h * b.z};
}

static slide_state_t runge_kutta(const slide_t *slide, slide_state_t m, double time, double h,
                                 double direction)
{
    const slide_state_t k1 = derivative(slide, m, time, direction);
    const slide_state_t k2 = derivative(slide, along(m, h / 2.0, k1), time + h / 2.0, direction);
    const slide_state_t k3 = derivative(slide, along(m, h / 2.0, k2), time + h / 2.0, direction);
    const slide_state_t k4 = derivative(slide, along(m, h, k3), time + h, direction);
    m = along(m, h / 6.0, k1);
    m = along(m, h / 3.0, k2);
    m = along(m, h / 3.0, k3);
    return along(m, h / 6.0, k4);
}

/* Coulomb friction turns around where the mass comes to rest: finds that moment within the step, and
   goes on from there */
static slide_state_t coulomb_step(const slide_t *slide, slide_state_t m, double time, double h)
{
    const double direction = direction_of(slide, &m, time);
    const slide_state_t whole = runge_kutta(slide, m, time, h, direction);
    if (direction * whole.v >= 0.0) {
        return whole;
    }
    double moving = 0.0;
    double turned = h;
    for (int i = 0; i < 50; i++) {
        const double middle = 0.5 * (moving + turned);
        if (direction * runge_kutta(slide, m, time, middle, direction).v >= 0.0) {
            moving = middle;
        } else {
            turned = middle;
        }
    }
    m = runge_kutta(slide, m, time, moving, direction);
    m.v = 0.0;
    const double onward = direction_of(slide, &m, time + moving);
    return runge_kutta(slide, m, time + moving, h - moving, onward);
}

slide_state_t slide_step(const slide_t *slide, slide_state_t motion, double time, double step)
{
    return slide->contact.model == CONTACT_COULOMB ? coulomb_step(slide, motion, time, step)
                                                   : runge_kutta(slide, motion, time, step, 0.0);
}

run_t run_from(const slide_t *slide, slide_state_t start, double rate)
{
    return (run_t){.slide = slide, .rate = rate, .coarse = start, .fine = start};
}

double run_time(const run_t *run)
{
    return (double)run->steps / run->rate;
}

static void note_distance(run_t *run)
{
    run->apart.x = larger(run->apart.x, fabs(run->fine.x - run->coarse.x));
    run->apart.v = larger(run->apart.v, fabs(run->fine.v - run->coarse.v));
    run->apart.z = larger(run->apart.z, fabs(run->fine.z - run->coarse.z));
}

void run_rejoin(run_t *run)
{
    run->coarse = run->fine;
}

void run_advance(run_t *run, long steps)
{
    const double fine_rate = 2.0 * run->rate;
    for (long i = 0; i < steps; i++, run->steps++) {
        const double fine_steps = 2.0 * (double)run->steps;
        run->coarse = slide_step(run->slide, run->coarse, run_time(run), 1.0 / run->rate);
        run->fine = slide_step(run->slide, run->fine, fine_steps / fine_rate, 1.0 / fine_rate);
        run->fine =
            slide_step(run->slide, run->fine, (fine_steps + 1.0) / fine_rate, 1.0 / fine_rate);
        note_distance(run);
    }
}
