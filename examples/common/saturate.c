/* SPDX-License-Identifier: MIT */
#include "saturate.h"

#include <float.h>
#include <math.h>

double saturate(double x, double least, double most)
{
    return fmax(fmin(x, most), least);
}

float saturate_float(double x)
{
    return (float)saturate(x, (double)-FLT_MAX, (double)FLT_MAX);
}
