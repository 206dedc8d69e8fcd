/* SPDX-License-Identifier: MIT */
/* All models on one motion, by every trigger: the continuous solution is computed once. */
#ifndef FIDELITY_RUN_H
#define FIDELITY_RUN_H

#include "fidelity_models.h"
#include "regimes.h"

/* By distance and by time; in the order of the tables */
enum { SPACINGS = 5, TRIGGERS = SPACINGS + 4 };
enum { AT_10_NM, AT_100_NM, AT_1_UM, AT_5_UM, AT_10_UM, AT_100_HZ, AT_1_KHZ, AT_5_KHZ, AT_20_KHZ };

/* "1 um", "1 kHz" */
const char *trigger_name(int trigger);
double trigger_value(int trigger); /* m or Hz */

enum { START_AND_STOP, SHAKEN, MOTIONS };

typedef struct {
    runner_t runners[TRIGGERS][MODELS];
    regimes_t regimes; /* updates at D_x = 0.1 um */
    double apart;      /* how far half the step of integration moves z, m */
} fidelity_t;

const char *fidelity_motion_name(int motion);

/* A mass of 10 kg with the friction of Table II */
void fidelity_run(fidelity_t *fidelity, int motion);

/* At the updates, in z_max; NaN if z became one */
double fidelity_rms(const fidelity_t *fidelity, int trigger, model_t model);
double fidelity_largest(const fidelity_t *fidelity, int trigger, model_t model);

#endif
