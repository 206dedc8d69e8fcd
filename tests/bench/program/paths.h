/* SPDX-License-Identifier: MIT */
/* The ways through one step of the algorithm. */
#ifndef PATHS_H
#define PATHS_H

/* Measures every function once: a contact that is deflected by z moves by dx at v, within dt. SI
   units, infinity for the largest number that the variant can say, NaN where it can. */
typedef void measure_t(float z, float dx, float v, float dt);

void every_path(measure_t *measure);

#endif
