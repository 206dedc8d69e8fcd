/* SPDX-License-Identifier: MIT */
/* An estimator of the library behind a spatial trigger, and how far it is off at its updates */
#ifndef TRACK_H
#define TRACK_H

#include "errors.h"
#include "trigger.h"
#include "variant.h"

typedef struct {
    trigger_t trigger;
    estimator_t estimator;
    double x;        /* where it began */
    errors_t errors; /* of z, m */
} track_t;

/* Starts an estimator. The parameters must suit the library: what the paper gives does. If they do not,
   that is reported, `variant` is NULL, and there is no estimate. */
void estimator_begin(estimator_t *estimator, const variant_t *variant, const epf_params_t *params,
                     const epf_lsb_t *lsb);

/* From rest at x, at the time 0. Without an estimator z and all errors are NaN, and no claim holds. */
void track_start(track_t *track, const variant_t *variant, const epf_params_t *params,
                 double spacing, double x);

/* The library's state to begin with, in place of 0; for f32 */
void track_set_z(track_t *track, double z);

/* One look at the sensor. If an update is due it is done, and compared with the z of the contact. */
bool track_look(track_t *track, double x, double time, double z);

double track_z(const track_t *track);
double track_force(const track_t *track);

#endif
