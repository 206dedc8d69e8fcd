/* SPDX-License-Identifier: MIT */
/*
 * What a user would otherwise take: models that are integrated over time, as one would write them in
 * single precision. In presliding LuGre is plastic from the first displacement on, and drifts; the
 * elasto-plastic model is the paper's (alpha of eq. (10)). Explicit Euler diverges when a step is large,
 * the exact solution for a velocity that is held over the step does not.
 */
#ifndef RIVALS_H
#define RIVALS_H

#include "naive.h"

/* The force after a time dt at the velocity v */
float lugre_euler_step(naive_t *contact, float v, float dt);
float lugre_exact_step(naive_t *contact, float v, float dt);
float ep_euler_step(naive_t *contact, float v, float dt);

#endif
