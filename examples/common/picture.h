/* SPDX-License-Identifier: MIT */
/* Pictures of results, made by gnuplot from a script: `gnuplot -c SCRIPT DATA PICTURE`. A picture is a PNG
   file, which appears complete or not at all, as in output.h. */
#ifndef PICTURE_H
#define PICTURE_H

#include "system.h"

#include <stdbool.h>

typedef struct {
    const char *script;
    const char *data;
    char name[SYSTEM_NAME_MAX + 1]; /* of the picture; empty: none is made */
} picture_t;

/* Chooses the name of the picture: the one given, or if it is NULL, that of the data with .png in place of its
   ending. The result is none if the data go to a stream, which cannot be read again. To be asked before
   anything is written. False, and the problem reported, if there can be no such picture. */
bool picture_choose(picture_t *picture, const char *script, const char *data, const char *name);

/* NULL: none is made */
const char *picture_name(const picture_t *picture);

/* Draws it, if there is one to make, and says so on stdout. Without gnuplot, which is another program and may
   be missing, it prints the command that would do it, ready to be pasted into a shell. False, and the problem
   reported, if gnuplot fails or the picture cannot be written: an earlier one is then still there. */
bool picture_make(const picture_t *picture);

#endif
