/* SPDX-License-Identifier: MIT */
/*
 * One step of the mean-value rule at a constant velocity, from many deflections, against the exact flow: what
 * its constants were chosen for. On a motion most steps are short, and a worse constant would not be seen.
 */
#ifndef FIDELITY_STEP_H
#define FIDELITY_STEP_H

#include "claims.h"

void fidelity_claim_steps(claims_t *claims);

#endif
