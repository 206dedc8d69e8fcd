/* SPDX-License-Identifier: MIT */
/* C leaves open what becomes of a double too large for the type that it is converted to: decided
   here, it becomes the largest value that there is. So does a NaN. */
#ifndef SATURATE_H
#define SATURATE_H

double saturate(double x, double least, double most);
float saturate_float(double x);

#endif
