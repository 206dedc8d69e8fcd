/* SPDX-License-Identifier: MIT */
/*
 * One update of z in discrete time, by rules that one could take in place of the library's: z after a
 * displacement dx, at the velocity v, which took the time dt. In double precision, and as their users
 * write them. The force is sigma_0 z + sigma_1 (z - z_before)/dt + sigma_2 v with all of them.
 */
#ifndef PLANT_RULES_H
#define PLANT_RULES_H

#include "friction.h"

typedef double rule_t(const friction_t *p, double z, double dx, double v, double dt);

/* dz/dt held over dt: what most programs do. Unstable where |v| dt > 2 z_ss. */
rule_t rule_lugre_euler;
rule_t rule_elasto_plastic_euler;

/* LuGre at constant v is linear: its solution after dt, an exponential ("zero-order hold") */
rule_t rule_lugre_exact;

/*
 * Algorithm 1 of the paper with the errors of its print. For v < 0 z_ss is negative, so that |z| >= z_ss
 * holds always and alpha jumps to 1 at z_ba; for v = 0 z_ss is 0 and divides: the result is NaN.
 */
rule_t rule_algorithm_1_as_printed;

/*
 * The elasto-plastic model itself over dx at constant v: dz/dx = 1 - alpha z/z_ss, to 1e-9 z_ss. With the
 * mean velocity of a step it is what a rule aims at. It is no bound: it errs where v changes within a step,
 * and the error of a rule may happen to point the other way.
 */
rule_t rule_exact_flow;

#endif
