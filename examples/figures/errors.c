/* SPDX-License-Identifier: MIT */
#include "errors.h"

#include <math.h>

void errors_add(errors_t *errors, double error)
{
    errors->squares += error * error;
    errors->largest = fmax(errors->largest, fabs(error));
    errors->count++;
}

double errors_rms(const errors_t *errors)
{
    return sqrt(errors->squares / (double)errors->count);
}
