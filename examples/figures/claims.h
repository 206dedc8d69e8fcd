/* SPDX-License-Identifier: MIT */
/*
 * What is claimed beside a figure: one line each, a row of the table in README.md
 *
 *     | figure | claim | measured | limit | holds or FAILS |
 */
#ifndef CLAIMS_H
#define CLAIMS_H

#include <stdbool.h>

typedef struct {
    const char *figure; /* in hand */
    unsigned stated, failed;
} claims_t;

/* The claim, as for printf, holds if what was measured is not above the limit, or not below it. A
   measurement that is no number holds nothing. */
void claim_at_most(claims_t *claims, double measured, double limit, const char *unit,
                   const char *format, ...);
void claim_at_least(claims_t *claims, double measured, double limit, const char *unit,
                    const char *format, ...);

/* Exit status, beside those of problem.h: the figures are made, but a claim does not hold */
enum { EXIT_CLAIM = 3 };

/* Prints how many claims there were and how many fail. False, and the problem reported, if one fails, or if
   there was none. */
bool claims_hold(const claims_t *claims);

#endif
