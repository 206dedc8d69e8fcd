/* SPDX-License-Identifier: MIT */
/* What a step costs on a Cortex-M4F: cycles, read from the baseline of the benchmark */
#ifndef FIDELITY_COSTS_H
#define FIDELITY_COSTS_H

#include <stdbool.h>
#include <stddef.h>

typedef struct {
    const char *variant, *rule; /* as tests/bench names them; NULL: not measured */
    unsigned long cycles;       /* the most of all paths; 0: the baseline has none */
} step_cost_t;

/* Reads the cycles of all of them, at once. False, and the problem reported, if the file is no such baseline. */
bool step_costs_read(step_cost_t costs[], size_t count, const char *file);

#endif
