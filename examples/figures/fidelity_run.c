/* SPDX-License-Identifier: MIT */
#include "fidelity_run.h"

#include "drive.h"
#include "progress.h"
#include "tables.h"

#include <math.h>

/* ---- the motions ---------------------------------------------------------------------------- */

/* Tremor; a slow ramp, break-away, a stop; the other way; a reversal without a stop; rest under load */
static const drive_point_t start_and_stop[] = {
    {0.00, 0.0},  {0.40, 0.0},  {1.20, 1.6}, {1.22, 1.6}, {1.24, 0.0}, {1.40, 0.0},
    {1.50, -1.6}, {1.54, -1.6}, {1.56, 0.0}, {1.70, 0.0}, {1.80, 1.6}, {1.85, 1.6},
    {2.00, -1.6}, {2.04, -1.6}, {2.10, 0.4}, {2.40, 0.4},
};
static const drive_sine_t tremor[] = {
    {.start = 0.0, .end = 0.4, .amplitude = 0.6, .frequency = 5.0},
};

/* Past v_s before the contact has left presliding */
static const drive_point_t level[] = {{0.0, 0.0}, {1.0, 0.0}};
static const drive_sine_t shaking[] = {
    {.start = 0.0, .end = 1.0, .amplitude = 5.0, .frequency = 20.0},
};

static const struct {
    const char *name;
    drive_t drive;
    double end; /* s */
} motions[MOTIONS] = {
    [START_AND_STOP] = {"start and stop",
                        {start_and_stop, sizeof start_and_stop / sizeof start_and_stop[0], tremor,
                         1},
                        2.4},
    [SHAKEN] = {"shaken", {level, 2, shaking, 1}, 1.2},
};

const char *fidelity_motion_name(int motion)
{
    return motions[motion].name;
}

/* ---- the triggers --------------------------------------------------------------------------- */

enum { LOOKS_PER_SECOND = 100000 }; /* steps of the integration as well */

static const struct {
    const char *name;
    double spacing; /* m; 0: updates are timed, */
    long looks;     /* so many of them apart */
} triggers[TRIGGERS] = {
    [AT_10_NM] = {"10 nm", 10e-9, 1},
    [AT_100_NM] = {"0.1 um", 0.1e-6, 1},
    [AT_1_UM] = {"1 um", 1e-6, 1},
    [AT_5_UM] = {"5 um", 5e-6, 1},
    [AT_10_UM] = {"10 um", 10e-6, 1},
    [AT_100_HZ] = {"100 Hz", 0.0, LOOKS_PER_SECOND / 100},
    [AT_1_KHZ] = {"1 kHz", 0.0, LOOKS_PER_SECOND / 1000},
    [AT_5_KHZ] = {"5 kHz", 0.0, LOOKS_PER_SECOND / 5000},
    [AT_20_KHZ] = {"20 kHz", 0.0, LOOKS_PER_SECOND / 20000},
};

const char *trigger_name(int trigger)
{
    return triggers[trigger].name;
}

double trigger_value(int trigger)
{
    const double spacing = triggers[trigger].spacing;
    return spacing > 0.0 ? spacing : (double)LOOKS_PER_SECOND / (double)triggers[trigger].looks;
}

/* ---- the run -------------------------------------------------------------------------------- */

static void look(fidelity_t *fidelity, trigger_t *trigger, int i, const run_t *run)
{
    update_t update;
    if (run->steps % triggers[i].looks != 0 ||
        !trigger_look(trigger, run->fine.x, run_time(run), &update)) {
        return;
    }
    for (int model = 0; model < MODELS; model++) {
        runner_update(&fidelity->runners[i][model], &update, &run->fine, run_time(run));
    }
    if (i == AT_100_NM) {
        regimes_add(&fidelity->regimes, &friction_table_2, run->fine.z, run->fine.v);
    }
}

static void start(fidelity_t *fidelity, trigger_t at[TRIGGERS])
{
    for (int i = 0; i < TRIGGERS; i++) {
        at[i] = (trigger_t){triggers[i].spacing, 0.0, 0.0};
        for (int model = 0; model < MODELS; model++) {
            runner_start(&fidelity->runners[i][model], (model_t)model, triggers[i].spacing);
        }
    }
    fidelity->regimes = (regimes_t){{0}};
}

void fidelity_run(fidelity_t *fidelity, int motion)
{
    const slide_t slide = {
        {friction_table_2, CONTACT_ELASTO_PLASTIC}, 10.0, drive_force, &motions[motion].drive};
    run_t run = run_from(&slide, (slide_state_t){0.0, 0.0, 0.0}, LOOKS_PER_SECOND);
    trigger_t at[TRIGGERS];
    start(fidelity, at);
    while (run_time(&run) < motions[motion].end) {
        run_advance(&run, 1);
        for (int i = 0; i < TRIGGERS; i++) {
            look(fidelity, &at[i], i, &run);
        }
        progress_show("fidelity, %s: %.2f of %.2f s", motions[motion].name, run_time(&run),
                      motions[motion].end);
    }
    progress_end();
    fidelity->apart = run.apart.z;
}

/* ---- its outcome ---------------------------------------------------------------------------- */

double fidelity_rms(const fidelity_t *fidelity, int trigger, model_t model)
{
    return errors_rms(&fidelity->runners[trigger][model].errors) /
           friction_z_max(&friction_table_2);
}

double fidelity_largest(const fidelity_t *fidelity, int trigger, model_t model)
{
    return errors_largest(&fidelity->runners[trigger][model].errors) /
           friction_z_max(&friction_table_2);
}
