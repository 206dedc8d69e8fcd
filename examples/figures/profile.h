/* SPDX-License-Identifier: MIT */
/*
 * The motion of Figs. 6, 7 and 8: a mass of 10 kg with the friction of Table II under a spike of force
 * that stays elastic, a large oscillation through presliding and sliding, and release at 1.0 s. The paper
 * gives its force as a picture only: this one is of its kind. And what follows that motion in Figs. 6
 * and 7.
 */
#ifndef PROFILE_H
#define PROFILE_H

#include "slide.h"
#include "track.h"

#include <stdio.h>

enum { PROFILE_STEPS_PER_SECOND = 50000 };
extern const double profile_end;     /* s */
extern const double profile_release; /* s: no force from here on */
extern const double profile_range;   /* of z, m: from -z_max to z_max, which the pictures show */

/* From rest; the slide is made, and must outlive the run */
run_t profile_run(slide_t *slide);

/* f32 by both rules, each an epf_update_t, at each of these spacings */
enum { PROFILE_RULES = 2, PROFILE_SPACINGS = 3 };
extern const double profile_spacings[PROFILE_SPACINGS]; /* m */

typedef struct {
    track_t tracks[PROFILE_RULES][PROFILE_SPACINGS];
} followers_t;

/* They begin with the deflection z, where the contact has none */
void followers_start(followers_t *followers, double z);
void followers_look(followers_t *followers, const run_t *run);

/* Time, force and motion, then z of each, by rule and spacing */
void followers_write_header(FILE *csv);
void followers_write_row(FILE *csv, const followers_t *followers, const run_t *run);

#endif
