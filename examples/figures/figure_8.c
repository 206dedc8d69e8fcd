/* SPDX-License-Identifier: MIT */
/*
 * Fig. 8 of the paper: the motion of Fig. 6 seen with uniform noise, by a loop at 5 kHz. Where D_x is at
 * least the peak-to-peak noise the estimate is off by little more than without; where it is below, the noise
 * alone makes updates, and the estimate is off by more than the noise.
 */
#include "encoder.h"
#include "figure.h"
#include "profile.h"
#include "regimes.h"
#include "tables.h"

#include <math.h>

enum { STEPS_PER_LOOK = 10, SEEDS = 10, CASES = 5 };

/* The noise either way and the spacing of the trigger, m, and the limits of the claims, in peak-to-peak
   noise: where the spacing is less, the least that the rms error may be; else the most that it may grow */
static const struct {
    double noise, spacing;
    double limits[PROFILE_RULES];
} cases[CASES] = {
    {0.5e-6, 0.5e-6, {1.0, 1.0}}, {0.5e-6, 1e-6, {0.3, 0.1}}, {0.5e-6, 2e-6, {0.05, 0.0}},
    {1e-6, 1e-6, {1.0, 1.0}},     {1e-6, 2e-6, {0.15, 0.15}},
};

/* One way of seeing the motion, by both rules. The picture shows the first seed. */
typedef struct {
    encoder_t encoder;
    track_t tracks[PROFILE_RULES];
} observer_t;

typedef struct {
    observer_t noisy[CASES][SEEDS];
    observer_t clean[CASES];
} observers_t;

static void observer_start(observer_t *observer, double noise, double spacing, int seed)
{
    observer->encoder = (encoder_t){.noise = noise, .source = {(uint64_t)seed}};
    for (int rule = 0; rule < PROFILE_RULES; rule++) {
        const epf_params_t params = params_of(&friction_table_2, (epf_update_t)rule);
        track_start(&observer->tracks[rule], &variant_f32, &params, spacing, 0.0);
    }
}

static void observer_look(observer_t *observer, const run_t *run)
{
    const double seen = encoder_read(&observer->encoder, run->fine.x);
    for (int rule = 0; rule < PROFILE_RULES; rule++) {
        (void)track_look(&observer->tracks[rule], seen, run_time(run), run->fine.z);
    }
}

static void start(observers_t *observers)
{
    for (int i = 0; i < CASES; i++) {
        observer_start(&observers->clean[i], 0.0, cases[i].spacing, 0);
        for (int seed = 0; seed < SEEDS; seed++) {
            observer_start(&observers->noisy[i][seed], cases[i].noise, cases[i].spacing, seed);
        }
    }
}

static void look(observers_t *observers, const run_t *run)
{
    for (int i = 0; i < CASES; i++) {
        observer_look(&observers->clean[i], run);
        for (int seed = 0; seed < SEEDS; seed++) {
            observer_look(&observers->noisy[i][seed], run);
        }
    }
}

static void write_header(FILE *csv)
{
    (void)fputs("time_s,z_um", csv);
    for (int rule = 0; rule < PROFILE_RULES; rule++) {
        for (int i = 0; i < CASES; i++) {
            (void)fprintf(csv, ",%s %g um at %g um", update_name((epf_update_t)rule),
                          2.0 * cases[i].noise / MICRO, cases[i].spacing / MICRO);
        }
    }
    (void)fputc('\n', csv);
}

static void write_row(FILE *csv, const observers_t *observers, const run_t *run)
{
    (void)fprintf(csv, "%.4f,%.6f", run_time(run), run->fine.z / MICRO);
    for (int rule = 0; rule < PROFILE_RULES; rule++) {
        for (int i = 0; i < CASES; i++) {
            (void)fprintf(csv, ",%.6f", track_z(&observers->noisy[i][0].tracks[rule]) / MICRO);
        }
    }
    (void)fputc('\n', csv);
}

/* The rms error at the updates, over all seeds, m */
static double rms(const observers_t *observers, int i, int rule)
{
    double squares = 0.0;
    double updates = 0.0;
    for (int seed = 0; seed < SEEDS; seed++) {
        const track_t *track = &observers->noisy[i][seed].tracks[rule];
        squares += track->errors.squares;
        updates += (double)track->errors.count;
    }
    return sqrt(squares / updates);
}

static void claim_case(claims_t *claims, const observers_t *observers, int i, int rule)
{
    const double peak_to_peak = 2.0 * cases[i].noise;
    const double clean = errors_rms(&observers->clean[i].tracks[rule].errors);
    const double noisy = rms(observers, i, rule);
    if (cases[i].spacing < peak_to_peak) {
        claim_at_least(claims, noisy / peak_to_peak, cases[i].limits[rule], "of the noise",
                       "%s, noise %g um peak to peak, D_x = %g um, too small: rms error (%.2g um)",
                       update_name((epf_update_t)rule), peak_to_peak / MICRO,
                       cases[i].spacing / MICRO, noisy / MICRO);
    } else {
        claim_at_most(
            claims, (noisy - clean) / peak_to_peak, cases[i].limits[rule], "of the noise",
            "%s, noise %g um peak to peak, D_x = %g um: rms error (%.2g um) less that without "
            "noise (%.2g um)",
            update_name((epf_update_t)rule), peak_to_peak / MICRO, cases[i].spacing / MICRO,
            noisy / MICRO, clean / MICRO);
    }
}

void figure_8(FILE *csv, claims_t *claims)
{
    static observers_t observers; /* too large for some stacks */
    slide_t slide;
    run_t run = profile_run(&slide);
    regimes_t regimes = {{0}};
    start(&observers);
    write_header(csv);
    write_row(csv, &observers, &run);
    while (run_time(&run) < profile_end) {
        run_advance(&run, STEPS_PER_LOOK);
        look(&observers, &run);
        regimes_add(&regimes, &friction_table_2, run.fine.z, run.fine.v);
        write_row(csv, &observers, &run);
    }
    regimes_claim(&regimes, REGIMES, claims, "looks");
    for (int rule = 0; rule < PROFILE_RULES; rule++) {
        for (int i = 0; i < CASES; i++) {
            claim_case(claims, &observers, i, rule);
        }
    }
}
