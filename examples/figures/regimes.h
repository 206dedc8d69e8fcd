/* SPDX-License-Identifier: MIT */
/* Where a contact was found, and how often: a figure on which everything slides or sticks shows nothing */
#ifndef REGIMES_H
#define REGIMES_H

#include "claims.h"
#include "friction.h"

/* Up to z_ba; between; within 5 % of z_ss(v); above it, where the paper's rule lets go at once */
typedef enum { REGIME_ELASTIC, REGIME_MIXED, REGIME_SLIDING, REGIME_CASE_1, REGIMES } regime_t;

typedef struct {
    unsigned long found[REGIMES];
} regimes_t;

/* Once more, at this deflection and velocity */
void regimes_add(regimes_t *regimes, const friction_t *friction, double z, double v);

/* % of all times; NaN if there are none */
double regimes_percent(const regimes_t *regimes, regime_t regime);

/* Claims each of those before the end (REGIMES: all) to be no rarity. What was counted is `of`: "updates" */
void regimes_claim(const regimes_t *regimes, regime_t end, claims_t *claims, const char *of);

#endif
