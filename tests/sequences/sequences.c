/* SPDX-License-Identifier: MIT */
#include "sequences.h"

#include "integers.h"

#include <float.h>
#include <math.h> /* INFINITY only */

double sequence_uniform(sequence_t *q, double low, double high)
{
    return low + (high - low) * ((double)(random_word(&q->random) >> 8) * (1.0 / 16777216.0));
}

/* Turns the oscillator by an angle whose tangent of the half is q->turn: exact but for rounding */
static double oscillate(sequence_t *q)
{
    const double t = q->turn;
    const double c = (1.0 - t * t) / (1.0 + t * t);
    const double s = 2.0 * t / (1.0 + t * t);
    const double sine = c * q->sine + s * q->cosine;
    q->cosine = c * q->cosine - s * q->sine;
    const double moved = sine - q->sine;
    q->sine = sine;
    return moved;
}

static sample_t moved_by(const sequence_t *q, double dx)
{
    return (sample_t){dx, dx * q->speed, 1e-3};
}

static sample_t slow_reversals(sequence_t *q)
{
    if (q->left-- == 0) {
        q->left = 20 + random_below(&q->random, 400);
        q->step = (q->step < 0.0 ? 1.0 : -1.0) * sequence_uniform(q, 0.002, 0.05);
    }
    return moved_by(q, q->step);
}

static sample_t chirp(sequence_t *q)
{
    q->turn = q->turn < 0.4 ? q->turn * 1.001 : 0.001;
    return moved_by(q, 3.0 * oscillate(q));
}

static sample_t tremor(sequence_t *q)
{
    q->turn = 0.17;
    return moved_by(q, 0.1 * oscillate(q));
}

static sample_t encoder(sequence_t *q)
{
    if (q->left-- == 0) {
        q->left = random_below(&q->random, 60);
        q->step = ((double)random_below(&q->random, 7) - 3.0) / 64.0; /* 0: a dwell */
    }
    return moved_by(q, q->step);
}

static sample_t random_walk(sequence_t *q)
{
    return moved_by(q, sequence_uniform(q, -0.3, 0.3));
}

static sample_t leaps(sequence_t *q)
{
    static const double exact[] = {2.0, -2.0, 1.0, -1.0};
    const uint32_t pick = random_below(&q->random, 16);
    return moved_by(q, pick < 4 ? exact[pick] : sequence_uniform(q, -5.0, 5.0));
}

static sample_t stribeck_sweep(sequence_t *q)
{
    if (q->left-- == 0) {
        q->left = 300 + random_below(&q->random, 300);
        q->step = sequence_uniform(q, -0.1, 0.1);
    }
    q->turn = q->v > 1e3 ? 0.97 : q->v < 1e-3 ? 1.03 : q->turn; /* here the growth of |v| */
    q->v *= q->turn;
    return (sample_t){q->step, q->step < 0.0 ? -q->v : q->v, 1e-3};
}

static sample_t sign_mismatch(sequence_t *q)
{
    const double dx = sequence_uniform(q, -0.5, 0.5);
    const double v = sequence_uniform(q, -3.0, 3.0);
    const uint32_t zero = random_below(&q->random, 8);
    return (sample_t){zero == 0 ? 0.0 : dx, zero == 1 ? 0.0 : v, 1e-3};
}

static double extreme(sequence_t *q)
{
    static const double magnitudes[] = {
        0.0, DBL_MIN, 1e-40, 1e-9,    5.9604644775390625e-8, 0.5, 1.0, 2.0,
        1e6, 1e30,    1e38,  DBL_MAX, (double)INFINITY};
    const double magnitude =
        magnitudes[random_below(&q->random, sizeof magnitudes / sizeof magnitudes[0])];
    return random_below(&q->random, 2) ? magnitude : -magnitude;
}

static sample_t extremes(sequence_t *q)
{
    static const double times[] = {1e-30, 1e-9, 1e-3, 1.0, 1e30};
    const double dx = extreme(q);
    const double v = extreme(q);
    return (sample_t){dx, v, times[random_below(&q->random, sizeof times / sizeof times[0])]};
}

static const struct {
    const char *name;
    sample_t (*next)(sequence_t *);
} kinds[SEQUENCE_KINDS] = {
    [SEQUENCE_SLOW_REVERSALS] = {"slow reversals", slow_reversals},
    [SEQUENCE_CHIRP] = {"chirp", chirp},
    [SEQUENCE_TREMOR] = {"tremor", tremor},
    [SEQUENCE_ENCODER] = {"encoder counts", encoder},
    [SEQUENCE_RANDOM_WALK] = {"random walk", random_walk},
    [SEQUENCE_LEAPS] = {"leaps", leaps},
    [SEQUENCE_STRIBECK_SWEEP] = {"Stribeck sweep", stribeck_sweep},
    [SEQUENCE_SIGN_MISMATCH] = {"sign mismatch", sign_mismatch},
    [SEQUENCE_EXTREMES] = {"extremes", extremes},
};

void sequence_start(sequence_t *q, sequence_kind_t kind, uint32_t seed)
{
    *q = (sequence_t){.kind = kind, .random = seed * 2654435761u + 1u, .cosine = 1.0};
    if (q->random == 0) {
        q->random = 1;
    }
    q->turn = kind == SEQUENCE_STRIBECK_SWEEP ? 1.03 : 0.001;
    q->v = 1e-3;
    q->speed = sequence_uniform(q, 0.5, 50.0);
}

sample_t sequence_next(sequence_t *q)
{
    return kinds[q->kind].next(q);
}

const char *sequence_name(sequence_kind_t kind)
{
    return kinds[kind].name;
}
