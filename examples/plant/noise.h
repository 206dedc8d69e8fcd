/* SPDX-License-Identifier: MIT */
/* A seeded source of random numbers, the same on every machine */
#ifndef PLANT_NOISE_H
#define PLANT_NOISE_H

#include <stdint.h>

typedef struct {
    uint64_t state; /* the seed: any number */
} noise_t;

/* Uniform in [-1, 1) */
double noise_next(noise_t *noise);

#endif
