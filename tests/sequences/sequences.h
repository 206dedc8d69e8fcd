/* SPDX-License-Identifier: MIT */
/*
 * Displacement sequences for all tests: generated from a seed, endless, and free of libm, so that
 * every variant on every target walks the same path.
 *
 * They are in the units of the contact, displacement in z_max and velocity in v_s, and each test
 * scales them to its parameters and its number format.
 */
#ifndef EPF_TESTS_SEQUENCES_H
#define EPF_TESTS_SEQUENCES_H

#include <stdint.h>

typedef enum {
    SEQUENCE_SLOW_REVERSALS, /* triangles of random length in small steps */
    SEQUENCE_CHIRP,          /* a sine of rising frequency, well beyond z_max */
    SEQUENCE_TREMOR,         /* a fast sine of 0.1 z_max: stays elastic in most contacts */
    SEQUENCE_ENCODER,        /* counts of 2^-6 z_max, with dwells */
    SEQUENCE_RANDOM_WALK,    /* steps up to 0.3 z_max either way */
    SEQUENCE_LEAPS,          /* steps up to and beyond 2 z_max */
    SEQUENCE_STRIBECK_SWEEP, /* |v| sweeps 1e-3 v_s to 1e3 v_s and back while sliding: case 1 */
    SEQUENCE_SIGN_MISMATCH,  /* velocity and displacement independent, also zero */
    SEQUENCE_EXTREMES,       /* zeros, subnormals, giants and infinities in any order */
    SEQUENCE_KINDS
} sequence_kind_t;

typedef struct {
    double dx; /* displacement, z_max */
    double v;  /* velocity, v_s */
    double dt; /* time, s */
} sample_t;

typedef struct {
    sequence_kind_t kind;
    uint32_t random;     /* state of the generator of random numbers, never 0 */
    uint32_t left;       /* samples left of the present stretch */
    double speed;        /* velocity per displacement, v_s/z_max */
    double sine, cosine; /* the oscillator */
    double turn;         /* tan of half its angle per sample */
    double step;         /* displacement or growth factor of the present stretch */
    double v;            /* swept velocity */
} sequence_t;

void sequence_start(sequence_t *q, sequence_kind_t kind, uint32_t seed);
sample_t sequence_next(sequence_t *q);
const char *sequence_name(sequence_kind_t kind);

/* Uniform in [low, high), from the same generator */
double sequence_uniform(sequence_t *q, double low, double high);

#endif
