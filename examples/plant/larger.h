/* SPDX-License-Identifier: MIT */
/* The larger and the smaller of two; NaN if one of them is, where fmax and fmin would drop it */
#ifndef PLANT_LARGER_H
#define PLANT_LARGER_H

double larger(double a, double b);
double smaller(double a, double b);

#endif
