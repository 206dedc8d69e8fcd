/* SPDX-License-Identifier: MIT */
/* A file that appears complete or not at all: it is written beside its place and renamed last. */
#ifndef OUTPUT_H
#define OUTPUT_H

#include <stdbool.h>
#include <stdio.h>

typedef struct {
    FILE *file;
    const char *name;
    char temporary[1100];
} output_t;

/* False, and the problem reported, if the file cannot be written. The name must outlive it. */
bool output_open(output_t *output, const char *name);

/* Puts the file in its place. False, and the problem reported, if anything could not be written. */
bool output_commit(output_t *output);

/* Leaves things as they were before output_open */
void output_discard(output_t *output);

#endif
