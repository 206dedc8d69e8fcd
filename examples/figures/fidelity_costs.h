/* SPDX-License-Identifier: MIT */
/* What a step costs on a Cortex-M4F: cycles, read from the baseline of the benchmark */
#ifndef FIDELITY_COSTS_H
#define FIDELITY_COSTS_H

/* The most of all paths through `step` of a variant by a rule, both as tests/bench names them; 0 if the
   file does not have it. If there is no such file, that is reported. */
unsigned long step_cycles(const char *file, const char *variant, const char *rule);

#endif
