/* SPDX-License-Identifier: MIT */
/* The errors of all models on one motion, as README.md has them: a table by distance, and one by time */
#ifndef FIDELITY_TABLE_H
#define FIDELITY_TABLE_H

#include "fidelity_run.h"

void fidelity_print(const fidelity_t *fidelity, int motion);

#endif
