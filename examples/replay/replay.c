/* SPDX-License-Identifier: MIT */
#include "replay.h"

#include <float.h>
#include <math.h>

/* How near to z_ss the state counts as having reached it: it tends to z_ss exponentially */
static const float nearly = 0.99f;

epf_status_t replay_start(replay_t *replay, const epf_params_t *params, bool has_velocity,
                          bool has_force)
{
    *replay = (replay_t){.has_velocity = has_velocity, .has_force = has_force};
    const epf_status_t status = epf_f32_coeffs_init(&replay->coeffs, params);
    if (status == EPF_OK) {
        epf_f32_init(&replay->estimator, &replay->coeffs);
    }
    return status;
}

/* ---- the motion between two rows ------------------------------------------------------------ */

typedef struct {
    float dx, v, dt;
} motion_t;

/* C leaves open what becomes of a double too large for a float: decide it here */
static float to_float(double x)
{
    return (float)fmax(fmin(x, (double)FLT_MAX), (double)-FLT_MAX);
}

/* Differences are taken in double: a position far from 0 must not cost the digits of a small step
 */
static motion_t motion_between(const csv_row_t *from, const csv_row_t *to, bool has_velocity)
{
    const double dx = to->value[CSV_POSITION] - from->value[CSV_POSITION];
    const double dt = to->value[CSV_TIME] - from->value[CSV_TIME];
    const double v = has_velocity ? to->value[CSV_VELOCITY] : dx / dt;
    return (motion_t){to_float(dx), to_float(v), to_float(dt)};
}

static int direction_of(float dx)
{
    return (dx > 0.0f) - (dx < 0.0f);
}

/* ---- the figures ---------------------------------------------------------------------------- */

/* The regime at the end of a motion */
static regime_t regime(const replay_t *replay, const motion_t *motion)
{
    const epf_f32_coeffs_t *c = &replay->coeffs;
    const float zeta = (float)direction_of(motion->dx) * epf_f32_z(&replay->estimator);
    const float z_ss = motion->v != 0.0f ? fabsf(epf_f32_fss(c, motion->v)) / c->sigma_0 : c->z_max;

    if (motion->dx == 0.0f || zeta <= c->z_ba) {
        return REGIME_ELASTIC;
    }
    return zeta >= nearly * z_ss ? REGIME_SLIDING : REGIME_MIXED;
}

static void count_motion(replay_t *replay, const motion_t *motion, double duration)
{
    replay_summary_t *s = &replay->summary;
    const int direction = direction_of(motion->dx);
    if (direction != 0) {
        if (direction == -replay->direction) {
            s->reversals++;
        }
        replay->direction = direction;
    }
    s->time_in[regime(replay, motion)] += duration;
    s->duration_s += duration;
    s->rejected = replay->estimator.rejected;
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

static replay_sample_t sample_now(const replay_t *replay, const csv_row_t *row)
{
    replay_sample_t sample = {
        .time_s = row->value[CSV_TIME],
        .displacement_m = row->value[CSV_POSITION] - replay->first.value[CSV_POSITION],
        .z_m = (double)epf_f32_z(&replay->estimator),
        .force_N = (double)epf_f32_output(&replay->estimator),
    };
    if (replay->has_force) {
        sample.measured_N = row->value[CSV_FORCE];
        sample.residual_N = sample.measured_N - sample.force_N;
    }
    return sample;
}

replay_sample_t replay_row(replay_t *replay, const csv_row_t *row)
{
    if (replay->summary.rows == 0) {
        replay->first = *row;
    } else {
        const motion_t motion = motion_between(&replay->last, row, replay->has_velocity);
        (void)epf_f32_step(&replay->estimator, motion.dx, motion.v, motion.dt);
        count_motion(replay, &motion, row->value[CSV_TIME] - replay->last.value[CSV_TIME]);
    }
    replay->last = *row;

    const replay_sample_t sample = sample_now(replay, row);
    count_sample(&replay->summary, &sample, (double)replay->coeffs.z_max);
    return sample;
}
