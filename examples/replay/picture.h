/* SPDX-License-Identifier: MIT */
/* The picture of a result, made by gnuplot. */
#ifndef PICTURE_H
#define PICTURE_H

#include <stdbool.h>

/* The name of the file that tells gnuplot how to draw */
extern const char picture_script[];

/* Has gnuplot draw `data` into `picture`. False if that did not work: gnuplot may be missing. */
bool picture_draw(const char *data, const char *picture);

/* Prints the command that draws the picture, ready to be pasted into a shell */
void picture_print_command(const char *data, const char *picture);

#endif
