/* SPDX-License-Identifier: MIT */
/* How far one estimator is from another that sees the same rows. The README defines every figure. */
#ifndef COMPARISON_H
#define COMPARISON_H

#include "variant.h"

typedef struct {
    unsigned long rows;
    double largest_z_m, largest_force_N; /* differences */
    double force_square_sum;
    double residual_square_sum; /* of the other estimator */
} comparison_t;

/* Takes the estimates after one row; the measured force counts only if there is one */
void comparison_add(comparison_t *comparison, const estimate_t *one, const estimate_t *other,
                    double measured_N);

double comparison_rms_force(const comparison_t *comparison);
double comparison_rms_residual(const comparison_t *comparison);

#endif
