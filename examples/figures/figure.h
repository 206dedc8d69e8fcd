/* SPDX-License-Identifier: MIT */
/* The figures, a file each: every one writes its numbers as CSV and states its claims. */
#ifndef FIGURE_H
#define FIGURE_H

#include "claims.h"

#include <stdio.h>

typedef void figure_t(FILE *csv, claims_t *claims);

figure_t figure_2, figure_3, figure_4, figure_5, figure_6, figure_7, figure_8, figure_fidelity;

#endif
