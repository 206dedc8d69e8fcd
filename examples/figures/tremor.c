/* SPDX-License-Identifier: MIT */
#include "tremor.h"
#include "larger.h"

#include "encoder.h"
#include "errors.h"
#include "noise.h"
#include "progress.h"
#include "slide.h"
#include "tables.h"
#include "track.h"

#include <math.h>
#include <stddef.h>

static const double pi = 3.14159265358979323846;

/* Sines of seeded frequencies about an offset, whose sum stays below 0.6 N, where f_ba is 0.8 N */
enum { SINES = 3, SECONDS = 3600, STEPS_PER_SECOND = 500 };
static const double offset = 0.3;    /* N */
static const double amplitude = 0.1; /* N, each */

typedef struct {
    double frequency[SINES]; /* Hz: 8 to 12, as of a hand */
} tremor_t;

static double force(const void *context, double time)
{
    const tremor_t *tremor = context;
    double sum = offset;
    for (int i = 0; i < SINES; i++) {
        sum += amplitude * sin(2.0 * pi * tremor->frequency[i] * time);
    }
    return fmin(time, 1.0) * sum; /* sets in within a second */
}

typedef struct {
    double furthest; /* m */
    double leaves;   /* when it passes 2 z_max, s */
    double plastic;  /* x - z at the end, m */
    double apart;    /* how far half the step moves the mass, m */
} outcome_t;

/* The library beside the mass, which sees it through an encoder at every step */
enum { VARIANTS = 3 };
static const variant_t *const variants[VARIANTS] = {&variant_f32, &variant_q31, &variant_q15};
static const double resolution = 10e-9; /* m */

typedef struct {
    encoder_t encoder;
    track_t tracks[VARIANTS];
    double off[VARIANTS]; /* largest |z - x|, m */
} watchers_t;

static void watchers_start(watchers_t *watchers)
{
    *watchers = (watchers_t){.encoder = {.resolution = resolution}};
    const epf_params_t params = params_of(&friction_table_1, EPF_UPDATE_MEAN_VALUE);
    for (int i = 0; i < VARIANTS; i++) {
        track_start(&watchers->tracks[i], variants[i], &params, 0.0, 0.0);
    }
}

static void watchers_look(watchers_t *watchers, const run_t *run)
{
    const double x = encoder_read(&watchers->encoder, run->fine.x);
    for (int i = 0; i < VARIANTS; i++) {
        track_t *track = &watchers->tracks[i];
        (void)track_look(track, x, run_time(run), run->fine.z);
        watchers->off[i] = larger(watchers->off[i], fabs(track_z(track) - x));
    }
}

/* The watchers may be NULL, for none */
static outcome_t shaken(const tremor_t *tremor, contact_model_t model, const char *name,
                        watchers_t *watchers)
{
    const slide_t slide = {{friction_table_1, model}, 1.0, force, tremor};
    run_t run = run_from(&slide, (slide_state_t){0.0, 0.0, 0.0}, STEPS_PER_SECOND);
    outcome_t outcome = {.leaves = HUGE_VAL};
    for (long i = 0; i < (long)SECONDS * STEPS_PER_SECOND; i++) {
        run_advance(&run, 1);
        if (watchers != NULL) {
            watchers_look(watchers, &run);
        }
        const double distance = fabs(run.fine.x);
        outcome.furthest = larger(outcome.furthest, distance);
        if (distance > 2.0 * friction_z_max(&friction_table_1)) {
            outcome.leaves = fmin(outcome.leaves, run_time(&run));
        }
        if (run.steps % STEPS_PER_SECOND == 0) {
            progress_show("tremor, %s: %ld of %d s", name, run.steps / STEPS_PER_SECOND, SECONDS);
        }
    }
    progress_end();
    outcome.plastic = run.fine.x - run.fine.z;
    outcome.apart = run.apart.x;
    return outcome;
}

static void claim_watchers(claims_t *claims, const watchers_t *watchers)
{
    static const double limits[VARIANTS] = {2e-5, 1e-5, 1e-3}; /* um: floats round at every step */
    for (int i = 0; i < VARIANTS; i++) {
        claim_at_most(claims, watchers->off[i] / MICRO, limits[i], "um",
                      "the same, seen by %s through an encoder of %g nm, %d times a second: z off "
                      "x by",
                      variants[i]->name, resolution / 1e-9, STEPS_PER_SECOND);
    }
}

void tremor_claims(claims_t *claims)
{
    noise_t noise = {1};
    tremor_t tremor;
    for (int i = 0; i < SINES; i++) {
        tremor.frequency[i] = 10.0 + 2.0 * noise_next(&noise);
    }
    const double bound = 2.0 * friction_z_max(&friction_table_1);
    watchers_t watchers;
    watchers_start(&watchers);
    const outcome_t ep = shaken(&tremor, CONTACT_ELASTO_PLASTIC, "elasto-plastic", &watchers);
    const outcome_t lugre = shaken(&tremor, CONTACT_LUGRE, "LuGre", NULL);

    claim_at_most(claims, ep.furthest / bound, 1.0, "(2 z_max)",
                  "an hour of tremor below f_ba, elasto-plastic: largest distance from the start");
    claim_at_most(claims, fabs(ep.plastic) / MICRO, 1e-12, "um",
                  "the same: x off z at the end, the plastic displacement");
    claim_at_most(claims, ep.apart / MICRO, 1e-3, "um", "the same: half the step moves x by");
    claim_watchers(claims, &watchers);
    claim_at_most(claims, lugre.leaves, 2.0, "s",
                  "the same tremor, LuGre: the distance is above 2 z_max from");
    claim_at_least(claims, lugre.furthest * 1e3, 50.0, "mm", "the same, LuGre: largest distance");
    claim_at_most(claims, lugre.apart * 1e3, 0.02, "mm",
                  "the same, LuGre: half the step moves x by");
}
