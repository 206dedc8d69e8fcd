/* SPDX-License-Identifier: MIT */
/* How far an estimate is off, at its updates: between them an error would tell of the trigger */
#ifndef ERRORS_H
#define ERRORS_H

typedef struct {
    double squares, largest;
    unsigned long count;
} errors_t;

void errors_add(errors_t *errors, double error);

/* Root of the mean square; NaN if there are none */
double errors_rms(const errors_t *errors);

#endif
