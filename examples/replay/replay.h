/* SPDX-License-Identifier: MIT */
/*
 * The estimator run over a motion, row by row, and the figures that sum the run up. Beside it runs
 * one of f32, which it is compared with. Knows nothing of files. The README defines every figure.
 */
#ifndef REPLAY_H
#define REPLAY_H

#include "comparison.h"
#include "record.h"
#include "setup.h"

/* What comes out for each row that goes in */
typedef struct {
    double time_s, displacement_m, z_m, force_N;
    double measured_N, residual_N; /* only if the force was measured */
} replay_sample_t;

typedef enum { REGIME_ELASTIC, REGIME_MIXED, REGIME_SLIDING, REGIMES } regime_t;

typedef struct {
    unsigned long rows;
    unsigned long reversals;
    double duration_s, time_in[REGIMES]; /* the duration is the sum of the times, s */
    double largest_z;                    /* |z|/z_max */
    double residual_sum, residual_square_sum;
    unsigned long rejected;
} replay_summary_t;

typedef struct {
    bool has_velocity, has_force; /* which columns the rows have */
    estimator_t estimator;
    estimator_t reference; /* f32, whatever the estimator is; it also has the model in SI units */
    csv_row_t first, last;
    int direction; /* of the last motion; 0 before any */
    replay_summary_t summary;
    comparison_t comparison; /* with the reference */
} replay_t;

/* Begins with the first row of an open record. The replay must then stay where it is, as its estimators
   must. False, and the problem reported, if the library refuses the parameters. */
bool replay_start(replay_t *replay, const setup_t *setup, const csv_record_t *record);

/* The coefficients of the model in SI units */
const epf_f32_coeffs_t *replay_model(const replay_t *replay);

/* Takes the next row. The first one is the initial state: at rest, no deflection, no force. */
replay_sample_t replay_row(replay_t *replay, const csv_row_t *row);

double replay_mean_residual(const replay_summary_t *summary);
double replay_rms_residual(const replay_summary_t *summary);

#endif
