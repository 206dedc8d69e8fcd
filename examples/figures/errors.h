/* SPDX-License-Identifier: MIT */
/* How far an estimate is off, at its updates: between them an error would tell of the trigger */
#ifndef ERRORS_H
#define ERRORS_H

typedef struct {
    double squares, most; /* read through the functions below */
    unsigned long count;
} errors_t;

void errors_add(errors_t *errors, double error);

/* Root of the mean square, and the largest without its sign. NaN if one of the errors was, or if there are
   none: then no claim about them holds. */
double errors_rms(const errors_t *errors);
double errors_largest(const errors_t *errors);

#endif
