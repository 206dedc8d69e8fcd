/* SPDX-License-Identifier: MIT */
/*
 * Fig. 3 of the paper: a mass of 1 kg with the friction of Table I under a force that oscillates about an
 * offset and stays below break-away, f_ba = 0.8 N. LuGre and Dahl drift, the elasto-plastic model does
 * not. The paper shows its force as a picture; this one rises from 0 to 0.7 N and back, three times in three
 * seconds, then nine times in three seconds.
 */
#include "encoder.h"
#include "errors.h"
#include "figure.h"
#include "larger.h"
#include "regimes.h"
#include "slide.h"
#include "tables.h"
#include "track.h"
#include "tremor.h"

#include <math.h>
#include <stddef.h>

static const double pi = 3.14159265358979323846;

/* s: the picture begins a second before the force, and shows two seconds after it */
static const double begin = -1.0;
enum { SPAN = 9, END = 8, STEPS_PER_SECOND = 10000, STEPS_PER_LOOK = 10, LOOKS_PER_ROW = 5 };

static const double slow = 1.0;         /* Hz, up to 3 s */
static const double fast = 3.0;         /* Hz, from there to 6 s */
static const double resolution = 10e-9; /* of the encoder, m */

static double force(const void *context, double since_begin)
{
    (void)context;
    const double time = since_begin + begin;
    if (time < 0.0 || time >= 6.0) {
        return 0.0;
    }
    return 0.35 * (1.0 - cos(2.0 * pi * (time < 3.0 ? slow : fast) * time));
}

enum { EP, LUGRE, DAHL, MODELS };
static const contact_model_t models[MODELS] = {CONTACT_ELASTO_PLASTIC, CONTACT_LUGRE, CONTACT_DAHL};
static const char *const names[MODELS] = {"elasto-plastic", "LuGre", "Dahl"};

typedef struct {
    slide_t slides[MODELS];
    run_t runs[MODELS];
    /* Positions when the force begins, when it becomes faster and when it ends */
    double at_0[MODELS], at_3[MODELS], at_6[MODELS];
    double furthest[MODELS];
    regimes_t regimes;   /* of the elasto-plastic contact */
    double lugre_leaves; /* when LuGre passes 2 z_max, s */
} state_t;

static void start(state_t *state)
{
    *state = (state_t){.lugre_leaves = HUGE_VAL};
    for (int i = 0; i < MODELS; i++) {
        state->slides[i] = (slide_t){{friction_table_1, models[i]}, 1.0, force, NULL};
        state->runs[i] =
            run_from(&state->slides[i], (slide_state_t){0.0, 0.0, 0.0}, STEPS_PER_SECOND);
    }
}

static double bound(void)
{
    return 2.0 * friction_z_max(&friction_table_1);
}

static void advance(state_t *state)
{
    for (int i = 0; i < MODELS; i++) {
        run_t *run = &state->runs[i];
        run_advance(run, STEPS_PER_LOOK);
        const double time = run_time(run) + begin;
        state->at_0[i] = time <= 0.0 ? run->fine.x : state->at_0[i];
        state->at_3[i] = time <= 3.0 ? run->fine.x : state->at_3[i];
        state->at_6[i] = time <= 6.0 ? run->fine.x : state->at_6[i];
        state->furthest[i] = larger(state->furthest[i], fabs(run->fine.x));
        if (i == LUGRE && fabs(run->fine.x) > bound()) {
            state->lugre_leaves = fmin(state->lugre_leaves, time);
        }
    }
    regimes_add(&state->regimes, &friction_table_1, state->runs[EP].fine.z, state->runs[EP].fine.v);
}

static void write_row(FILE *csv, const state_t *state)
{
    const double since_begin = run_time(&state->runs[EP]);
    (void)fprintf(csv, "%.3f,%.6f", since_begin + begin, force(NULL, since_begin));
    for (int i = 0; i < MODELS; i++) {
        (void)fprintf(csv, ",%.6f", state->runs[i].fine.x / MICRO);
    }
    (void)fputc('\n', csv);
}

static void claim_drift(claims_t *claims, const state_t *state)
{
    double apart = 0.0;
    for (int i = 0; i < MODELS; i++) {
        apart = larger(apart, state->runs[i].apart.x);
    }
    claim_at_most(claims, apart / MICRO, 1e-5, "um",
                  "half the step moves no position by more than");
    claim_at_least(claims, regimes_percent(&state->regimes, REGIME_ELASTIC), 100.0, "%",
                   "elasto-plastic: looks that find the contact elastic");
    claim_at_most(claims, fabs(state->runs[EP].fine.x) / MICRO, 1e-12, "um",
                  "elasto-plastic: distance from the start at %d s, after the force", END);
    for (int i = LUGRE; i <= DAHL; i++) {
        const double slowly = state->at_3[i] - state->at_0[i];
        const double quickly = state->at_6[i] - state->at_3[i];
        claim_at_least(claims, fabs(state->runs[i].fine.x) / MICRO, 3.0 * bound() / MICRO, "um",
                       "%s: distance from the start at %d s; 2 z_max is %g um", names[i], END,
                       bound() / MICRO);
        claim_at_least(claims, quickly / slowly, 2.0, "",
                       "%s: drift per second at %g Hz over that at %g Hz", names[i], fast, slow);
    }
}

static void claim_static_friction(claims_t *claims, const state_t *state)
{
    claim_at_most(claims, state->furthest[EP] / bound(), 1.0, "(2 z_max)",
                  "elasto-plastic: largest distance from the start; static friction, as section II "
                  "defines it, keeps it below 2 z_max");
    claim_at_most(claims, state->lugre_leaves, 3.0, "s",
                  "LuGre: the distance is above 2 z_max from");
}

/* The library on the motion of the elasto-plastic mass, seen by an encoder at 1 kHz */
enum { VARIANTS = 3 };
static const variant_t *const variants[VARIANTS] = {&variant_f32, &variant_q31, &variant_q15};

typedef struct {
    encoder_t encoder;
    track_t tracks[VARIANTS];
    double off[VARIANTS]; /* largest |z - x| */
} estimators_t;

static void start_estimators(estimators_t *estimators)
{
    *estimators = (estimators_t){.encoder = {.resolution = resolution}};
    const epf_params_t params = params_of(&friction_table_1, EPF_UPDATE_MEAN_VALUE);
    for (int i = 0; i < VARIANTS; i++) {
        track_start(&estimators->tracks[i], variants[i], &params, 0.0, 0.0);
    }
}

static void look(estimators_t *estimators, const run_t *run)
{
    const double x = encoder_read(&estimators->encoder, run->fine.x);
    for (int i = 0; i < VARIANTS; i++) {
        (void)track_look(&estimators->tracks[i], x, run_time(run), run->fine.z);
        estimators->off[i] = larger(estimators->off[i], fabs(track_z(&estimators->tracks[i]) - x));
    }
}

static void claim_estimators(claims_t *claims, const estimators_t *estimators)
{
    static const double limits[VARIANTS] = {1e-6, 1e-5, 1e-3}; /* um */
    for (int i = 0; i < VARIANTS; i++) {
        claim_at_most(
            claims, estimators->off[i] / MICRO, limits[i], "um",
            "%s on the elasto-plastic motion: z off x, as an encoder of %g nm tells it, by",
            variants[i]->name, resolution / 1e-9);
    }
}

void figure_3(FILE *csv, claims_t *claims)
{
    state_t state;
    estimators_t estimators;
    start(&state);
    start_estimators(&estimators);
    (void)fputs("time_s,force_N,elasto_plastic_um,lugre_um,dahl_um\n", csv);
    write_row(csv, &state);
    const long looks = (long)SPAN * STEPS_PER_SECOND / STEPS_PER_LOOK;
    for (long i = 1; i <= looks; i++) {
        advance(&state);
        look(&estimators, &state.runs[EP]);
        if (i % LOOKS_PER_ROW == 0) {
            write_row(csv, &state);
        }
    }
    claim_drift(claims, &state);
    claim_estimators(claims, &estimators);
    claim_static_friction(claims, &state);
    tremor_claims(claims);
}
