/* SPDX-License-Identifier: MIT */
/* A file that appears complete or not at all: it is written beside its place and renamed last. What is
   no ordinary file, a FIFO or a device, is written as it stands; at the end of a link, its file is. */
#ifndef OUTPUT_H
#define OUTPUT_H

#include "system.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

typedef struct {
    FILE *file;
    const char *name;
    bool is_stream; /* written as it stands: neither target nor temporary matters */
    char target[SYSTEM_NAME_MAX + 1];
    char temporary[SYSTEM_NAME_MAX + 1];
} output_t;

/* To be asked before anything is written: is every output a file of its own, neither an input nor another
   output? NULL stands for none. False, and the problem reported, if not. */
bool output_check(const char *const outputs[], size_t n_outputs, const char *const inputs[],
                  size_t n_inputs);

/* False, and the problem reported, if the file cannot be written. The name must outlive it. */
bool output_open(output_t *output, const char *name);

/* Puts the file in its place. False, and the problem reported, if anything could not be written. */
bool output_commit(output_t *output);

/* Leaves things as they were before output_open; a stream keeps what it was given */
void output_discard(output_t *output);

/* The last call of a program, with its exit status. What was printed may still wait in a buffer; if it does
   not arrive, that is a problem, which is reported, and the status becomes EXIT_DATA. */
int output_finish(int status);

#endif
