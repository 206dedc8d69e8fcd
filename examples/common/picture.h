/* SPDX-License-Identifier: MIT */
/* Pictures of results, made by gnuplot from a script: `gnuplot -c SCRIPT DATA PICTURE`. */
#ifndef PICTURE_H
#define PICTURE_H

#include <stdbool.h>

/* Has gnuplot draw `data` into `picture`. False if that did not work: gnuplot may be missing. */
bool picture_draw(const char *script, const char *data, const char *picture);

/* Prints the command that draws the picture, ready to be pasted into a shell */
void picture_print_command(const char *script, const char *data, const char *picture);

#endif
