/* SPDX-License-Identifier: MIT */
#include "track.h"

#include "problem.h"

#include <math.h>
#include <stddef.h>

void estimator_begin(estimator_t *estimator, const variant_t *variant, const epf_params_t *params,
                     const epf_lsb_t *lsb)
{
    const epf_status_t status = estimator_start(estimator, variant, params, lsb);
    if (status != EPF_OK) {
        (void)problem("%s: %s", variant->name, epf_status_text(status));
        estimator->variant = NULL;
    }
}

void track_start(track_t *track, const variant_t *variant, const epf_params_t *params,
                 double spacing, double x)
{
    *track = (track_t){.trigger = {spacing, x, 0.0}, .x = x};
    epf_lsb_t lsb = {0.0f, 0.0f, 0.0f, 0.0f};
    if (variant->format != NULL) {
        lsb = variant_default_lsb(variant, params);
    }
    estimator_begin(&track->estimator, variant, params, &lsb);
}

void track_set_z(track_t *track, double z)
{
    if (track->estimator.variant != NULL) {
        epf_f32_reset(&track->estimator.as.f32.contact, (float)z);
    }
}

bool track_look(track_t *track, double x, double time, double z)
{
    update_t update;
    if (!trigger_look(&track->trigger, x, time, &update)) {
        return false;
    }
    const motion_t motion = {update.dx, update.v, update.dt, x - track->x, time};
    if (track->estimator.variant != NULL) {
        estimator_step(&track->estimator, &motion);
    }
    errors_add(&track->errors, track_z(track) - z);
    return true;
}

static estimate_t estimate(const track_t *track)
{
    return track->estimator.variant != NULL ? estimator_estimate(&track->estimator)
                                            : (estimate_t){(double)NAN, (double)NAN, 0};
}

double track_z(const track_t *track)
{
    return estimate(track).z_m;
}

double track_force(const track_t *track)
{
    return estimate(track).force_N;
}
