/* SPDX-License-Identifier: MIT */
#include "errors.h"

#include "larger.h"

#include <math.h>

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
