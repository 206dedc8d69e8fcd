/* SPDX-License-Identifier: MIT */
/*
 * Fig. 4 of the paper in kind (it shows a measurement): very slow motion, +-0.15 um/s, seen by a noisy
 * sensor. From one look to the next the noise moves more than the contact does. LuGre takes all of it for
 * sliding and under-estimates the friction; the elasto-plastic estimator does not. The contact has the
 * friction of Table I.
 */
#include "encoder.h"
#include "figure.h"
#include "regimes.h"
#include "rules.h"
#include "tables.h"
#include "track.h"

#include <math.h>

enum { LOOKS_PER_SECOND = 100, SECONDS = 1400, LOOKS_PER_ROW = 100 };
static const double speed = 0.15e-6;   /* m/s */
static const double range = 30e-6;     /* m either way: enough for LuGre to settle */
static const double noise = 5e-9;      /* m either way: 10 nm peak to peak */
static const double resolution = 1e-9; /* m */

/* D_x, m: the peak-to-peak noise, to which rounding adds a count */
static double spacing(void)
{
    return 2.0 * noise + resolution;
}

/* s: here the CSV has every look, for the inset of the picture */
static const double inset_begins = 300.0;
static const double inset_ends = 301.0;

/* 0 to +range, to -range and so on, at constant speed */
static double position(double time)
{
    const double phase = fmod(speed * time / range, 4.0);
    return range * (phase < 1.0 ? phase : phase < 3.0 ? 2.0 - phase : phase - 4.0);
}

enum { TRIGGERED, EVERY_LOOK, ESTIMATORS };

typedef struct {
    encoder_t encoder;
    double x, seen;       /* at the last look */
    double z;             /* of the contact: by the exact flow, for its speed is constant */
    double lugre;         /* z of LuGre as it takes the sensor */
    double lugre_exactly; /* and without noise */
    track_t tracks[ESTIMATORS];
    regimes_t regimes;
    /* Sums of s z near the end of each slide */
    double sliding, lugre_sliding, lugre_exactly_sliding, track_sliding[ESTIMATORS];
} state_t;

static void start(state_t *state)
{
    *state = (state_t){.encoder = {resolution, noise, {4}}};
    const epf_params_t params = params_of(&friction_table_1, EPF_UPDATE_MEAN_VALUE);
    track_start(&state->tracks[TRIGGERED], &variant_f32, &params, spacing(), 0.0);
    track_start(&state->tracks[EVERY_LOOK], &variant_f32, &params, 0.0, 0.0);
}

static void sum_sliding(state_t *state, double direction)
{
    if (direction * state->x < 0.75 * range) {
        return;
    }
    state->sliding += direction * state->z;
    state->lugre_sliding += direction * state->lugre;
    state->lugre_exactly_sliding += direction * state->lugre_exactly;
    for (int i = 0; i < ESTIMATORS; i++) {
        state->track_sliding[i] += direction * track_z(&state->tracks[i]);
    }
}

static void look(state_t *state, double time)
{
    const double dt = 1.0 / LOOKS_PER_SECOND;
    const double x = position(time);
    const double dx = x - state->x;
    state->z = rule_exact_flow(&friction_table_1, state->z, dx, dx / dt, dt);
    state->lugre_exactly =
        rule_lugre_exact(&friction_table_1, state->lugre_exactly, dx, dx / dt, dt);
    state->x = x;
    regimes_add(&state->regimes, &friction_table_1, state->z, dx / dt);

    const double seen = encoder_read(&state->encoder, x);
    const double v = (seen - state->seen) / dt;
    state->lugre = rule_lugre_exact(&friction_table_1, state->lugre, seen - state->seen, v, dt);
    state->seen = seen;
    for (int i = 0; i < ESTIMATORS; i++) {
        (void)track_look(&state->tracks[i], seen, time, state->z);
    }
    sum_sliding(state, dx < 0.0 ? -1.0 : 1.0);
}

static void write_row(FILE *csv, const state_t *state, double time)
{
    const double sigma_0 = friction_table_1.sigma_0;
    (void)fprintf(csv, "%.2f,%.4f,%.6f,%.6f,%.6f\n", time, state->seen / MICRO, sigma_0 * state->z,
                  sigma_0 * track_z(&state->tracks[TRIGGERED]), sigma_0 * state->lugre);
}

static void claim_friction(claims_t *claims, const state_t *state)
{
    const double all = state->sliding / 100.0;
    const double nm = spacing() / 1e-9;
    claim_at_most(claims, state->lugre_sliding / all, 50.0, "% of it",
                  "LuGre under-estimates the friction of a slide: it tells");
    claim_at_least(claims, state->lugre_exactly_sliding / all, 95.0, "% of it",
                   "because of the noise: without, LuGre tells");
    claim_at_least(claims, state->track_sliding[TRIGGERED] / all, 99.0, "% of it",
                   "f32 at D_x = %g nm, the peak-to-peak noise, tells", nm);
    claim_at_least(claims, state->track_sliding[EVERY_LOOK] / all, 85.0, "% of it",
                   "f32 at every look, without the trigger, tells");
    claim_at_most(claims, errors_largest(&state->tracks[TRIGGERED].errors) / MICRO, 0.02, "um",
                  "f32 at D_x = %g nm: largest error of z at the updates", nm);
}

void figure_4(FILE *csv, claims_t *claims)
{
    state_t state;
    start(&state);
    (void)fputs("time_s,seen_um,contact_N,estimate_N,lugre_N\n", csv);
    for (long i = 0; i <= (long)SECONDS * LOOKS_PER_SECOND; i++) {
        const double time = (double)i / LOOKS_PER_SECOND;
        if (i > 0) {
            look(&state, time);
        }
        if (i % LOOKS_PER_ROW == 0 || (time > inset_begins && time < inset_ends)) {
            write_row(csv, &state, time);
        }
    }
    regimes_claim(&state.regimes, REGIME_CASE_1, claims, "looks"); /* v is constant */
    claim_friction(claims, &state);
}
