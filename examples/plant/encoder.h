/* SPDX-License-Identifier: MIT */
/* A position sensor: uniform noise, then rounding to whole counts */
#ifndef PLANT_ENCODER_H
#define PLANT_ENCODER_H

#include "noise.h"

typedef struct {
    double resolution; /* m per count; 0: none */
    double noise;      /* m, either way; its peak-to-peak is twice that */
    noise_t source;
} encoder_t;

/* What it says of the position x, m */
double encoder_read(encoder_t *encoder, double x);

#endif
