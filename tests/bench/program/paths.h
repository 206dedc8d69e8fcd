/* SPDX-License-Identifier: MIT */
/* The ways through one step of the algorithm. */
#ifndef PATHS_H
#define PATHS_H

#include "contact.h"

/* A contact that is deflected by z moves by dx at v, within dt. SI units; infinity for the largest
   number that the variant can say, NaN where it can. */
typedef struct {
    float z, dx, v, dt;
} motion_t;

/* Measures every function once */
typedef void measure_t(motion_t motion);

void every_path(const contact_t *contact, measure_t *measure);

#endif
