/* SPDX-License-Identifier: MIT */
#include "profile.h"

#include "drive.h"
#include "tables.h"

/* The spike is short: the mass turns back before the contact slips */
static const drive_point_t points[] = {
    {0.00, 0.0}, {0.05, 0.0}, {0.06, 1.5}, {0.07, 0.0}, {1.00, 0.0},
};
static const drive_sine_t sines[] = {
    {.start = 0.2, .end = 1.0, .amplitude = 1.6, .frequency = 2.5},
};
static const drive_t drive = {points, sizeof points / sizeof points[0], sines,
                              sizeof sines / sizeof sines[0]};

const double profile_end = 1.2;
const double profile_release = 1.0;
const double profile_range = 30e-6;

run_t profile_run(slide_t *slide)
{
    *slide = (slide_t){{friction_table_2, CONTACT_ELASTO_PLASTIC}, 10.0, drive_force, &drive};
    return run_from(slide, (slide_state_t){0.0, 0.0, 0.0}, PROFILE_STEPS_PER_SECOND);
}

const double profile_spacings[PROFILE_SPACINGS] = {0.1e-6, 1e-6, 5e-6};

void followers_start(followers_t *followers, double z)
{
    for (int rule = 0; rule < PROFILE_RULES; rule++) {
        const epf_params_t params = params_of(&friction_table_2, (epf_update_t)rule);
        for (int i = 0; i < PROFILE_SPACINGS; i++) {
            track_t *track = &followers->tracks[rule][i];
            track_start(track, &variant_f32, &params, profile_spacings[i], 0.0);
            track_set_z(track, z);
        }
    }
}

void followers_look(followers_t *followers, const run_t *run)
{
    for (int rule = 0; rule < PROFILE_RULES; rule++) {
        for (int i = 0; i < PROFILE_SPACINGS; i++) {
            (void)track_look(&followers->tracks[rule][i], run->fine.x, run_time(run), run->fine.z);
        }
    }
}

void followers_write_header(FILE *csv)
{
    (void)fputs("time_s,force_N,x_um,z_um", csv);
    for (int rule = 0; rule < PROFILE_RULES; rule++) {
        for (int i = 0; i < PROFILE_SPACINGS; i++) {
            (void)fprintf(csv, ",%s %g um", update_name((epf_update_t)rule),
                          profile_spacings[i] / MICRO);
        }
    }
    (void)fputc('\n', csv);
}

void followers_write_row(FILE *csv, const followers_t *followers, const run_t *run)
{
    const double time = run_time(run);
    (void)fprintf(csv, "%.5f,%.6f,%.6f,%.6f", time, drive_force(&drive, time), run->fine.x / MICRO,
                  run->fine.z / MICRO);
    for (int rule = 0; rule < PROFILE_RULES; rule++) {
        for (int i = 0; i < PROFILE_SPACINGS; i++) {
            (void)fprintf(csv, ",%.6f", track_z(&followers->tracks[rule][i]) / MICRO);
        }
    }
    (void)fputc('\n', csv);
}
