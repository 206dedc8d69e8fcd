/* SPDX-License-Identifier: MIT */
/* What mean_value.h does in fractions, by its equations in double precision: for tests of either variant,
   which include the source of the variant before this. */
#ifndef EPF_TESTS_MEAN_VALUE_IN_DOUBLE_H
#define EPF_TESTS_MEAN_VALUE_IN_DOUBLE_H

#include <math.h>
#include <stdbool.h>

static double root_in_double(double v)
{
    return 1.0 - v + 0.625 * v * v;
}

/* Where the step begins at a share u of the span from z_ss, with p = d/(4 S) and r = S/z_ss */
static double share_in_double(double u, double p, double r)
{
    const double w = u * (1.0 - 1.25 * p);
    const double b = w * (2.75 - 1.625 * w);
    const double h = root_in_double(p * (b + r * (1.0 - w * b)));
    return u * h * h;
}

/* let_go() within a share of the excess, and the unit that it adds: near a ratio of 4, too, where
   the rest of the excess is all let go */
static bool let_go_is_close(int32_t z_ss, int32_t excess, int32_t d, double tolerance)
{
    const double q = fmin((double)d / z_ss, 4.0);
    const double h = root_in_double(q / 4.0);
    const double exact = excess * fmin(q * h * h, 1.0);
    return fabs(let_go(z_ss, excess, d) - exact) <= 1.0 + tolerance * excess;
}

#endif
