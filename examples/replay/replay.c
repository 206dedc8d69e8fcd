/* SPDX-License-Identifier: MIT */
#include "replay.h"

#include "saturate.h"

#include <math.h>
#include <stddef.h>

/* How near to z_ss the state counts as having reached it: it tends to z_ss exponentially */
static const float nearly = 0.99f;

bool replay_start(replay_t *replay, const setup_t *setup, const csv_record_t *record)
{
    setup_t reference = *setup;
    reference.variant = &variant_f32;
    *replay = (replay_t){.has_velocity = csv_has(record, RECORD_VELOCITY),
                         .has_force = csv_has(record, RECORD_FORCE)};
    return setup_start(&reference, &replay->reference) && setup_start(setup, &replay->estimator);
}

const epf_f32_coeffs_t *replay_model(const replay_t *replay)
{
    return &replay->reference.as.f32.coeffs;
}

/* ---- the motion between two rows ------------------------------------------------------------ */

/* Differences are taken in double: of a small step far from 0, float would lose the digits */
static motion_t motion_to(const replay_t *replay, const csv_row_t *row)
{
    const double *const first = replay->first.value;
    const double *const last = replay->last.value;
    const double *const now = row->value;
    motion_t motion = {
        .dx = now[RECORD_POSITION] - last[RECORD_POSITION],
        .dt = now[RECORD_TIME] - last[RECORD_TIME],
        .end_x = now[RECORD_POSITION] - first[RECORD_POSITION],
        .end_t = now[RECORD_TIME] - first[RECORD_TIME],
    };
    motion.v = replay->has_velocity ? now[RECORD_VELOCITY] : motion.dx / motion.dt;
    return motion;
}

static int direction_of(double dx)
{
    return (dx > 0.0) - (dx < 0.0);
}

/* ---- the figures ---------------------------------------------------------------------------- */

/* The regime at the end of a motion */
static regime_t regime(const epf_f32_coeffs_t *c, const motion_t *motion, double z)
{
    const float v = saturate_float(motion->v);
    const float z_ss = v != 0.0f ? fabsf(epf_f32_fss(c, v)) / c->sigma_0 : c->z_max;
    const double zeta = direction_of(motion->dx) * z;

    if (motion->dx == 0.0 || zeta <= (double)c->z_ba) {
        return REGIME_ELASTIC;
    }
    return zeta >= (double)(nearly * z_ss) ? REGIME_SLIDING : REGIME_MIXED;
}

static void count_motion(replay_t *replay, const motion_t *motion, const estimate_t *estimate)
{
    replay_summary_t *s = &replay->summary;
    const int direction = direction_of(motion->dx);
    if (direction != 0) {
        if (direction == -replay->direction) {
            s->reversals++;
        }
        replay->direction = direction;
    }
    s->time_in[regime(replay_model(replay), motion, estimate->z_m)] += motion->dt;
    s->duration_s += motion->dt;
    s->rejected = estimate->rejected;
}

static void count_sample(replay_summary_t *summary, const replay_sample_t *sample, double z_max)
{
    summary->rows++;
    summary->largest_z = fmax(summary->largest_z, fabs(sample->z_m) / z_max);
    summary->residual_sum += sample->residual_N;
    summary->residual_square_sum += sample->residual_N * sample->residual_N;
}

double replay_mean_residual(const replay_summary_t *summary)
{
    return summary->residual_sum / (double)summary->rows;
}

double replay_rms_residual(const replay_summary_t *summary)
{
    return sqrt(summary->residual_square_sum / (double)summary->rows);
}

/* ---- the run -------------------------------------------------------------------------------- */

static replay_sample_t sample_of(const replay_t *replay, const csv_row_t *row,
                                 const estimate_t *estimate)
{
    replay_sample_t sample = {
        .time_s = row->value[RECORD_TIME],
        .displacement_m = row->value[RECORD_POSITION] - replay->first.value[RECORD_POSITION],
        .z_m = estimate->z_m,
        .force_N = estimate->force_N,
    };
    if (replay->has_force) {
        sample.measured_N = row->value[RECORD_FORCE];
        sample.residual_N = sample.measured_N - sample.force_N;
    }
    return sample;
}

static void move_to(replay_t *replay, const csv_row_t *row)
{
    const motion_t motion = motion_to(replay, row);
    estimator_step(&replay->estimator, &motion);
    estimator_step(&replay->reference, &motion);

    const estimate_t estimate = estimator_estimate(&replay->estimator);
    count_motion(replay, &motion, &estimate);
}

replay_sample_t replay_row(replay_t *replay, const csv_row_t *row)
{
    if (replay->summary.rows == 0) {
        replay->first = *row;
    } else {
        move_to(replay, row);
    }
    replay->last = *row;

    const estimate_t estimate = estimator_estimate(&replay->estimator);
    const estimate_t reference = estimator_estimate(&replay->reference);
    const replay_sample_t sample = sample_of(replay, row, &estimate);
    count_sample(&replay->summary, &sample, (double)replay_model(replay)->z_max);
    comparison_add(&replay->comparison, &estimate, &reference, sample.measured_N);
    return sample;
}
