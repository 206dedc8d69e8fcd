/* SPDX-License-Identifier: MIT */
/* The picture of a result, made by gnuplot. */
#ifndef PICTURE_H
#define PICTURE_H

#include <stdbool.h>

/* Has gnuplot draw `data` into `picture`. False if that did not work: gnuplot may be missing, and
   names with blanks or other characters that a shell could misunderstand are not passed to one. */
bool picture_draw(const char *data, const char *picture);

/* Prints the command that draws the picture, ready to be pasted into a shell */
void picture_print_command(const char *data, const char *picture);

#endif
