/* SPDX-License-Identifier: MIT */
#include "comparison.h"

#include <math.h>

void comparison_add(comparison_t *comparison, const estimate_t *one, const estimate_t *other,
                    double measured_N)
{
    const double force = one->force_N - other->force_N;
    const double residual = measured_N - other->force_N;
    comparison->rows++;
    comparison->largest_z_m = fmax(comparison->largest_z_m, fabs(one->z_m - other->z_m));
    comparison->largest_force_N = fmax(comparison->largest_force_N, fabs(force));
    comparison->force_square_sum += force * force;
    comparison->residual_square_sum += residual * residual;
}

double comparison_rms_force(const comparison_t *comparison)
{
    return sqrt(comparison->force_square_sum / (double)comparison->rows);
}

double comparison_rms_residual(const comparison_t *comparison)
{
    return sqrt(comparison->residual_square_sum / (double)comparison->rows);
}
