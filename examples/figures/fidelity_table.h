/* SPDX-License-Identifier: MIT */
/* The errors of all models on one motion, as README.md has them: a table by distance, and one by time */
#ifndef FIDELITY_TABLE_H
#define FIDELITY_TABLE_H

#include "fidelity_run.h"

#include <stdbool.h>

/* Reads from the benchmark what the steps cost, to be printed too. False, and the problem reported, if that
   cannot be read. */
bool fidelity_table_prepare(void);

void fidelity_print(const fidelity_t *fidelity, int motion);

#endif
