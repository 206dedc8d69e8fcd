/* SPDX-License-Identifier: MIT */
/*
 * Fig. 6 of the paper: updates triggered by D_x = 0.1, 1 and 5 um against the continuous solution. The
 * picture shows estimators whose initial state is wrong by -10 um; how close they come is measured with
 * others, whose initial state is right.
 */
#include "figure.h"
#include "larger.h"
#include "profile.h"
#include "regimes.h"
#include "rules.h"
#include "tables.h"

#include <math.h>

enum { STEPS_PER_ROW = 25 };
static const double wrong_by = -10e-6;

static const double slide_begins = 0.20; /* s: until then all is elastic */
static const double slide_has_ended = 0.40;

enum { VARIANTS = 3 };
static const variant_t *const variants[VARIANTS] = {&variant_f32, &variant_q31, &variant_q15};

/* The exact solution of the model over each displacement, at its mean velocity */
typedef struct {
    trigger_t trigger;
    double z;
    errors_t errors;
} flow_t;

typedef struct {
    followers_t right, wrong;
    flow_t flows[PROFILE_SPACINGS];
    track_t variants[VARIANTS]; /* mean value, at the smallest spacing */
    errors_t forces[VARIANTS];  /* how far their friction is off, N */
    regimes_t regimes;          /* at their updates */
    double plastic;             /* largest |x - z| before the slide, m */
    double swinging;            /* largest error of `wrong` once the force is gone, D_x */
    /* How far apart `right` and `wrong` are, m */
    double apart_before[PROFILE_RULES][PROFILE_SPACINGS];
    double apart_after[PROFILE_RULES][PROFILE_SPACINGS];
} state_t;

static void start(state_t *state)
{
    *state = (state_t){.plastic = 0.0};
    for (int i = 0; i < PROFILE_SPACINGS; i++) {
        state->flows[i] = (flow_t){.trigger = {profile_spacings[i], 0.0, 0.0}};
    }
    followers_start(&state->right, 0.0);
    followers_start(&state->wrong, wrong_by);
    const epf_params_t params = params_of(&friction_table_2, EPF_UPDATE_MEAN_VALUE);
    for (int i = 0; i < VARIANTS; i++) {
        track_start(&state->variants[i], variants[i], &params, profile_spacings[0], 0.0);
    }
}

static void note_apart(const state_t *state, double apart[PROFILE_RULES][PROFILE_SPACINGS])
{
    for (int rule = 0; rule < PROFILE_RULES; rule++) {
        for (int i = 0; i < PROFILE_SPACINGS; i++) {
            apart[rule][i] = fabs(track_z(&state->wrong.tracks[rule][i]) -
                                  track_z(&state->right.tracks[rule][i]));
        }
    }
}

static void flow_look(flow_t *flow, const run_t *run)
{
    update_t update;
    if (trigger_look(&flow->trigger, run->fine.x, run_time(run), &update)) {
        flow->z = rule_exact_flow(&friction_table_2, flow->z, update.dx, update.v, update.dt);
        errors_add(&flow->errors, flow->z - run->fine.z);
    }
}

static void variants_look(state_t *state, const run_t *run)
{
    const slide_state_t *motion = &run->fine;
    const double time = run_time(run);
    for (int i = 0; i < VARIANTS; i++) {
        track_t *track = &state->variants[i];
        if (track_look(track, motion->x, time, motion->z)) {
            const double force = slide_friction(run->slide, motion, time);
            errors_add(&state->forces[i], track_force(track) - force);
            if (i == 0) {
                regimes_add(&state->regimes, &friction_table_2, motion->z, motion->v);
            }
        }
    }
}

/* Of an estimator whose initial state was wrong, in D_x */
static double error_of_wrong(const state_t *state, int rule, int i, const run_t *run)
{
    return fabs(track_z(&state->wrong.tracks[rule][i]) - run->fine.z) / profile_spacings[i];
}

/* After the release the contact swings on; the estimates wait for the next D_x */
static void note_swinging(state_t *state, const run_t *run)
{
    for (int rule = 0; rule < PROFILE_RULES; rule++) {
        for (int i = 0; i < PROFILE_SPACINGS; i++) {
            state->swinging = larger(state->swinging, error_of_wrong(state, rule, i, run));
        }
    }
}

static void note(state_t *state, const run_t *run)
{
    const double time = run_time(run);
    if (time <= slide_begins) {
        state->plastic = larger(state->plastic, fabs(run->fine.x - run->fine.z));
        note_apart(state, state->apart_before);
    }
    if (time <= slide_has_ended) {
        note_apart(state, state->apart_after);
    }
    if (time >= profile_release) {
        note_swinging(state, run);
    }
}

static void look(state_t *state, const run_t *run)
{
    for (int i = 0; i < PROFILE_SPACINGS; i++) {
        flow_look(&state->flows[i], run);
    }
    followers_look(&state->right, run);
    followers_look(&state->wrong, run);
    variants_look(state, run);
    note(state, run);
}

static double percent(double distance)
{
    return 100.0 * distance / profile_range;
}

static void claim_closeness(claims_t *claims, const state_t *state)
{
    /* % of the plot's height, at 0.1, 1 and 5 um */
    static const double limits[PROFILE_RULES][PROFILE_SPACINGS] = {{3.0, 3.0, 15.0},
                                                                   {0.2, 2.5, 15.0}};
    for (int rule = 0; rule < PROFILE_RULES; rule++) {
        for (int i = 0; i < PROFILE_SPACINGS; i++) {
            const track_t *track = &state->right.tracks[rule][i];
            claim_at_most(claims, percent(errors_largest(&track->errors)), limits[rule][i],
                          "% of the plot",
                          "%s, D_x = %g um: largest error of z at the updates (rms %.2g %%)",
                          update_name((epf_update_t)rule), profile_spacings[i] / MICRO,
                          percent(errors_rms(&track->errors)));
        }
    }
    for (int i = 1; i < VARIANTS; i++) {
        const track_t *track = &state->variants[i];
        claim_at_most(claims, percent(errors_largest(&track->errors)),
                      limits[EPF_UPDATE_MEAN_VALUE][0], "% of the plot",
                      "%s, mean value, D_x = %g um: the same (rms %.2g %%)", variants[i]->name,
                      profile_spacings[0] / MICRO, percent(errors_rms(&track->errors)));
    }
}

/* The friction that the mass feels, damping and all: each estimate's is that of a mean over its step */
static void claim_force(claims_t *claims, const state_t *state)
{
    for (int i = 0; i < VARIANTS; i++) {
        const double unit = friction_table_2.f_max / 100.0;
        claim_at_most(claims, errors_rms(&state->forces[i]) / unit, 0.4, "% of f_max",
                      "%s, mean value, D_x = %g um: rms error of the force (largest %.2g %%)",
                      variants[i]->name, profile_spacings[0] / MICRO,
                      errors_largest(&state->forces[i]) / unit);
    }
}

/* rms errors: of the mean-value rule over the exact flow, and of the published rule over the mean-value */
static void claim_rms(claims_t *claims, const state_t *state)
{
    const track_t *saturated = state->right.tracks[EPF_UPDATE_SATURATED];
    const track_t *mean_value = state->right.tracks[EPF_UPDATE_MEAN_VALUE];
    for (int i = 0; i < PROFILE_SPACINGS; i++) {
        const double least = errors_rms(&state->flows[i].errors);
        claim_at_most(claims, errors_rms(&mean_value[i].errors) / least, 1.05, "",
                      "mean value, D_x = %g um: rms error over that of the exact flow, the exact "
                      "solution at the mean velocity",
                      profile_spacings[i] / MICRO);
    }
    const double times = errors_rms(&saturated[0].errors) / errors_rms(&mean_value[0].errors);
    claim_at_least(claims, times, 8.0, "",
                   "saturated: off where a slide gathers speed, however small D_x: rms error at "
                   "%g um over that of mean value",
                   profile_spacings[0] / MICRO);
}

static void claim_convergence(claims_t *claims, const state_t *state)
{
    double least = HUGE_VAL;
    for (int rule = 0; rule < PROFILE_RULES; rule++) {
        for (int i = 0; i < PROFILE_SPACINGS; i++) {
            least = smaller(least, state->apart_before[rule][i]);
        }
    }
    claim_at_least(
        claims, least / MICRO, 9.0, "um",
        "initial error of %g um: what is left of it at %g s, before the slide, the least "
        "of both rules and every D_x",
        wrong_by / MICRO, slide_begins);
    for (int rule = 0; rule < PROFILE_RULES; rule++) {
        for (int i = 0; i < PROFILE_SPACINGS; i++) {
            claim_at_most(claims, state->apart_after[rule][i] / MICRO, 1e-5, "um",
                          "%s, D_x = %g um: initial error left after one slide (%.3g um before)",
                          update_name((epf_update_t)rule), profile_spacings[i] / MICRO,
                          state->apart_before[rule][i] / MICRO);
        }
    }
}

static void claim_final_error(claims_t *claims, const state_t *state, const run_t *run)
{
    for (int rule = 0; rule < PROFILE_RULES; rule++) {
        for (int i = 0; i < PROFILE_SPACINGS; i++) {
            claim_at_most(claims, error_of_wrong(state, rule, i, run), 1.0, "D_x",
                          "%s, D_x = %g um: error at the end, %g s",
                          update_name((epf_update_t)rule), profile_spacings[i] / MICRO,
                          profile_end);
        }
    }
    claim_at_most(claims, state->swinging, 2.0, "D_x",
                  "from the release on, while the contact still swings: largest error, the most of "
                  "both rules and every D_x");
}

void figure_6(FILE *csv, claims_t *claims)
{
    slide_t slide;
    run_t run = profile_run(&slide);
    state_t state;
    start(&state);
    followers_write_header(csv);
    followers_write_row(csv, &state.wrong, &run);
    while (run_time(&run) < profile_end) {
        run_advance(&run, 1);
        look(&state, &run);
        if (run.steps % STEPS_PER_ROW == 0) {
            followers_write_row(csv, &state.wrong, &run);
        }
    }
    claim_at_most(claims, run.apart.z / MICRO, 2e-6, "um", "half the step moves z by no more than");
    claim_at_most(claims, state.plastic / MICRO, 1e-9, "um",
                  "the spike stays elastic: largest x - z up to %g s", slide_begins);
    regimes_claim(&state.regimes, REGIMES, claims, "updates at D_x = 0.1 um");
    claim_closeness(claims, &state);
    claim_force(claims, &state);
    claim_rms(claims, &state);
    claim_convergence(claims, &state);
    claim_final_error(claims, &state, &run);
}
