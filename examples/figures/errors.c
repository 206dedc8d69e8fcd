/* SPDX-License-Identifier: MIT */
#include "errors.h"

#include <math.h>

double larger(double a, double b)
{
    return isnan(a) || a > b ? a : b;
}

double smaller(double a, double b)
{
    return isnan(a) || a < b ? a : b;
}

void errors_add(errors_t *errors, double error)
{
    errors->squares += error * error;
    errors->most = larger(errors->most, fabs(error));
    errors->count++;
}

double errors_rms(const errors_t *errors)
{
    return sqrt(errors->squares / (double)errors->count);
}

double errors_largest(const errors_t *errors)
{
    return errors->count > 0 ? errors->most : (double)NAN;
}
