/* SPDX-License-Identifier: MIT */
#include "track.h"

#include "problem.h"

#include <stdlib.h>

void track_start(track_t *track, const variant_t *variant, const epf_params_t *params,
                 double spacing, double x)
{
    *track = (track_t){.trigger = {spacing, x, 0.0}, .x = x};
    epf_lsb_t lsb = {0.0f, 0.0f, 0.0f, 0.0f};
    if (variant->format != NULL) {
        lsb = variant_default_lsb(variant, params);
    }
    const epf_status_t status = estimator_start(&track->estimator, variant, params, &lsb);
    if (status != EPF_OK) {
        (void)problem("%s: %s", variant->name, epf_status_text(status));
        exit(EXIT_FAILURE);
    }
}

void track_set_z(track_t *track, double z)
{
    epf_f32_reset(&track->estimator.as.f32.contact, (float)z);
}

bool track_look(track_t *track, double x, double time, double z)
{
    update_t update;
    if (!trigger_look(&track->trigger, x, time, &update)) {
        return false;
    }
    const motion_t motion = {update.dx, update.v, update.dt, x - track->x, time};
    estimator_step(&track->estimator, &motion);
    errors_add(&track->errors, track_z(track) - z);
    return true;
}

double track_z(const track_t *track)
{
    return estimator_estimate(&track->estimator).z_m;
}
