/* SPDX-License-Identifier: MIT */
/* What the user gets to see: the result as a CSV file, and the summary. */
#ifndef REPORT_H
#define REPORT_H

#include "replay.h"

#include <stdio.h>

void report_header(FILE *file, bool has_force);
void report_row(FILE *file, const replay_sample_t *sample, bool has_force);

/* Prints the figures of a run on stdout */
void report_summary(const replay_t *replay);

#endif
