/* SPDX-License-Identifier: MIT */
/* The spatial trigger of the paper: an update is due when |x - x_last| >= D_x */
#ifndef PLANT_TRIGGER_H
#define PLANT_TRIGGER_H

#include <stdbool.h>

typedef struct {
    double spacing; /* D_x, m; 0: at every look */
    double x, time; /* at the last update */
} trigger_t;

/* What the estimator is told */
typedef struct {
    double dx; /* since the last update, m */
    double dt; /* s */
    double v;  /* dx/dt, the mean: what the update rules want */
} update_t;

/* Looks at x; if an update is due, says so and takes it as the last one */
bool trigger_look(trigger_t *trigger, double x, double time, update_t *update);

#endif
