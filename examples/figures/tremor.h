/* SPDX-License-Identifier: MIT */
/* An hour of tremor below break-away: which of the models keeps the mass? */
#ifndef TREMOR_H
#define TREMOR_H

#include "claims.h"

void tremor_claims(claims_t *claims);

#endif
