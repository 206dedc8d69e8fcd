/* SPDX-License-Identifier: MIT */
/*
 * Fig. 7 of the paper: details of Fig. 6. The initial error of -10 um goes away as the contact begins to
 * slide; the slide gathers speed, and z_ss(v) falls below z (case 1); the force is released.
 */
#include "figure.h"
#include "profile.h"
#include "tables.h"

#include <stddef.h>

enum { STEPS_PER_ROW = 5 };
enum { BREAK_AWAY, SLIDING, RELEASE, SEGMENTS };

static const struct {
    double begin, end; /* s */
    const char *name;
} segments[SEGMENTS] = {
    [BREAK_AWAY] = {0.20, 0.34, "break-away"},
    [SLIDING] = {0.65, 0.81, "sliding"},
    [RELEASE] = {0.98, 1.10, "release"},
};

/* Of the segment in hand; the next one begins afresh */
static void forget_errors(followers_t *followers)
{
    for (int rule = 0; rule < PROFILE_RULES; rule++) {
        for (int i = 0; i < PROFILE_SPACINGS; i++) {
            followers->tracks[rule][i].errors.largest = 0.0;
        }
    }
}

/* Largest error at the updates, in % of the plot's height */
static double largest(const track_t *track)
{
    return 100.0 * track->errors.largest / profile_range;
}

static void claim_segment(claims_t *claims, const followers_t *followers, int segment)
{
    static const double limits[2] = {0.3, 2.5}; /* at 0.1 and 1 um */
    const char *name = segments[segment].name;
    for (int i = 0; i < 2; i++) {
        claim_at_most(claims, largest(&followers->tracks[EPF_UPDATE_MEAN_VALUE][i]), limits[i],
                      "% of the plot", "%s, mean value, D_x = %g um: largest error", name,
                      profile_spacings[i] / MICRO);
    }
    if (segment == SLIDING) {
        claim_at_least(claims, largest(&followers->tracks[EPF_UPDATE_SATURATED][0]), 2.0,
                       "% of the plot",
                       "%s, saturated, D_x = %g um: largest error: it lets go at once (case 1)",
                       name, profile_spacings[0] / MICRO);
    }
}

static void advance_to(followers_t *shown, followers_t *right, run_t *run, double time, FILE *csv)
{
    while (run_time(run) < time) {
        run_advance(run, 1);
        followers_look(shown, run);
        followers_look(right, run);
        if (csv != NULL && run->steps % STEPS_PER_ROW == 0) {
            followers_write_row(csv, shown, run);
        }
    }
}

void figure_7(FILE *csv, claims_t *claims)
{
    slide_t slide;
    run_t run = profile_run(&slide);
    followers_t shown;
    followers_t right;
    followers_start(&shown, -10e-6);
    followers_start(&right, 0.0);
    followers_write_header(csv);
    for (int i = 0; i < SEGMENTS; i++) {
        advance_to(&shown, &right, &run, segments[i].begin, NULL);
        forget_errors(&right);
        advance_to(&shown, &right, &run, segments[i].end, csv);
        claim_segment(claims, &right, i);
    }
}
