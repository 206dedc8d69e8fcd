/* SPDX-License-Identifier: MIT */
#include "tremor.h"

#include "noise.h"
#include "progress.h"
#include "slide.h"
#include "tables.h"

#include <math.h>

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

static outcome_t shaken(const tremor_t *tremor, contact_model_t model, const char *name)
{
    const slide_t slide = {{table_1, model}, 1.0, force, tremor};
    run_t run = run_from(&slide, (slide_state_t){0.0, 0.0, 0.0}, STEPS_PER_SECOND);
    outcome_t outcome = {.leaves = HUGE_VAL};
    for (long i = 0; i < (long)SECONDS * STEPS_PER_SECOND; i++) {
        run_advance(&run, 1);
        const double distance = fabs(run.fine.x);
        outcome.furthest = fmax(outcome.furthest, distance);
        if (distance > 2.0 * friction_z_max(&table_1)) {
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

void tremor_claims(claims_t *claims)
{
    noise_t noise = {1};
    tremor_t tremor;
    for (int i = 0; i < SINES; i++) {
        tremor.frequency[i] = 10.0 + 2.0 * noise_next(&noise);
    }
    const double bound = 2.0 * friction_z_max(&table_1);
    const outcome_t ep = shaken(&tremor, CONTACT_ELASTO_PLASTIC, "elasto-plastic");
    const outcome_t lugre = shaken(&tremor, CONTACT_LUGRE, "LuGre");

    claim_at_most(claims, ep.furthest / bound, 1.0, "(2 z_max)",
                  "an hour of tremor below f_ba, elasto-plastic: largest distance from the start");
    claim_at_most(claims, fabs(ep.plastic) / MICRO, 1e-6, "um",
                  "the same: x off z at the end, the plastic displacement");
    claim_at_most(claims, ep.apart / MICRO, 1e-2, "um", "the same: half the step moves x by");
    claim_at_most(claims, lugre.leaves, SECONDS, "s",
                  "the same tremor, LuGre: the distance is above 2 z_max from");
    claim_at_least(claims, lugre.furthest * 1e3, bound * 1e3, "mm",
                   "the same, LuGre: largest distance");
    claim_at_most(claims, lugre.apart * 1e3, 1.0, "mm",
                  "the same, LuGre: half the step moves x by");
}
