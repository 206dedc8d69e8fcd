/* SPDX-License-Identifier: MIT */
/* Pictures of results, made by gnuplot from a script: `gnuplot -c SCRIPT DATA PICTURE`. */
#ifndef PICTURE_H
#define PICTURE_H

#include <stdbool.h>
#include <stddef.h>

/* Draws `data` into `picture` and says so on stdout. Without gnuplot, which is another program and may be
   missing, it prints the command that would do it, ready to be pasted into a shell. */
void picture_make(const char *script, const char *data, const char *picture);

/* The name of a picture beside its data: with .png in place of their ending. False if it does not fit. */
bool picture_name(char *name, size_t size, const char *data);

#endif
