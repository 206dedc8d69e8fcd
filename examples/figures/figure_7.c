/* SPDX-License-Identifier: MIT */
/*
 * Fig. 7 of the paper: three details of Fig. 6. Break-away, where the initial error of -10 um goes; sliding,
 * where the slide gathers speed and z_ss(v) falls below z (case 1); and the release. The picture shows the
 * estimators whose initial state is wrong; the errors are those of others, whose initial state is right.
 */
#include "figure.h"
#include "profile.h"
#include "regimes.h"
#include "tables.h"

#include <stddef.h>

enum { STEPS_PER_ROW = 5 };
enum { BREAK_AWAY, SLIDING, RELEASE, SEGMENTS };
enum { CLOSE_SPACINGS = 2 }; /* 0.1 and 1 um */

static const struct {
    double begin, end; /* s */
    const char *name;
    regime_t regime; /* it must pass through */
    const char *looks;
    double limits[PROFILE_RULES][CLOSE_SPACINGS]; /* of the largest error, % of the plot */
} segments[SEGMENTS] = {
    [BREAK_AWAY] = {0.20, 0.34, "break-away", REGIME_MIXED, "mixed", {{3.0, 3.0}, {0.002, 0.03}}},
    [SLIDING] = {0.65, 0.78, "sliding", REGIME_CASE_1, "in case 1", {{3.0, 3.0}, {0.2, 2.5}}},
    [RELEASE] = {0.98, 1.10, "release", REGIME_ELASTIC, "elastic", {{0.5, 2.5}, {0.2, 2.5}}},
};

/* What is shown, what is measured, and where the contact was in the segment in hand */
typedef struct {
    followers_t shown, right;
    regimes_t regimes;
} state_t;

static void begin_segment(state_t *state)
{
    state->regimes = (regimes_t){{0}};
    for (int rule = 0; rule < PROFILE_RULES; rule++) {
        for (int i = 0; i < PROFILE_SPACINGS; i++) {
            state->right.tracks[rule][i].errors = (errors_t){0.0, 0.0, 0};
        }
    }
}

/* Largest error at the updates, in % of the plot's height */
static double largest(const state_t *state, int rule, int i)
{
    return 100.0 * errors_largest(&state->right.tracks[rule][i].errors) / profile_range;
}

static void claim_segment(claims_t *claims, const state_t *state, int segment)
{
    const char *name = segments[segment].name;
    claim_at_least(claims, regimes_percent(&state->regimes, segments[segment].regime), 5.0, "%",
                   "%s (%g to %g s): looks that find the contact %s", name, segments[segment].begin,
                   segments[segment].end, segments[segment].looks);
    for (int rule = 0; rule < PROFILE_RULES; rule++) {
        for (int i = 0; i < CLOSE_SPACINGS; i++) {
            claim_at_most(claims, largest(state, rule, i), segments[segment].limits[rule][i],
                          "% of the plot", "%s, %s, D_x = %g um: largest error", name,
                          update_name((epf_update_t)rule), profile_spacings[i] / MICRO);
        }
    }
    if (segment == SLIDING) {
        claim_at_least(claims, largest(state, EPF_UPDATE_SATURATED, 0), 2.0, "% of the plot",
                       "%s, saturated, D_x = %g um: largest error: it lets go at once (case 1)",
                       name, profile_spacings[0] / MICRO);
    }
}

static void advance_to(state_t *state, run_t *run, double time, FILE *csv)
{
    while (run_time(run) < time) {
        run_advance(run, 1);
        followers_look(&state->shown, run);
        followers_look(&state->right, run);
        regimes_add(&state->regimes, &friction_table_2, run->fine.z, run->fine.v);
        if (csv != NULL && run->steps % STEPS_PER_ROW == 0) {
            followers_write_row(csv, &state->shown, run);
        }
    }
}

void figure_7(FILE *csv, claims_t *claims)
{
    slide_t slide;
    run_t run = profile_run(&slide);
    state_t state;
    followers_start(&state.shown, -10e-6);
    followers_start(&state.right, 0.0);
    followers_write_header(csv);
    for (int i = 0; i < SEGMENTS; i++) {
        advance_to(&state, &run, segments[i].begin, NULL);
        begin_segment(&state);
        advance_to(&state, &run, segments[i].end, csv);
        claim_segment(claims, &state, i);
    }
}
