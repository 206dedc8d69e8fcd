/* SPDX-License-Identifier: MIT */
#include "larger.h"

#include <math.h>

double larger(double a, double b)
{
    return isnan(a) || a > b ? a : b;
}

double smaller(double a, double b)
{
    return isnan(a) || a < b ? a : b;
}
