/* SPDX-License-Identifier: MIT */
/*
 * What C99 does not tell: which file a name leads to, a new file for sure, interrupts, terminals, other programs.
 * system_posix.c asks POSIX. system_c99.c is for other systems; it compares names as they are written.
 */
#ifndef SYSTEM_H
#define SYSTEM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum { SYSTEM_NAME_MAX = 4095 };

/* True if to write one of them is to write the other: through links or not, also before there is such
   a file. A terminal or another character device may serve twice: nothing is lost by that. */
bool system_same_file(const char *one, const char *other);

/* True if the name leads to what must be written as it stands, and not be replaced by a new file: a
   FIFO, a device, a folder (which then refuses), or the file that stdout or stderr goes to */
bool system_is_stream(const char *name);

/* Opens a stream. Where stdout goes it is shared with stdout, so that neither overwrites the other. */
FILE *system_open_stream(const char *name);

/* Puts the name of the file at the end of all symbolic links into `target`, of SYSTEM_NAME_MAX + 1
   bytes; the file need not be there. False if there is no end, or the name is too long. */
bool system_follow(char *target, const char *name);

/* Opens a new file beside `name` and puts its name into `temporary`, of SYSTEM_NAME_MAX + 1 bytes. An
   interrupt removes it, until system_keep(). NULL if that does not work: no file is overwritten. */
FILE *system_create(char *temporary, const char *name);

void system_keep(void);

bool system_stderr_is_terminal(void);

typedef enum { GNUPLOT_SUCCEEDED, GNUPLOT_FAILED, GNUPLOT_NOT_RUN } gnuplot_status_t;

/* Runs `gnuplot -c` with these three arguments, in silence. GNUPLOT_NOT_RUN if there is no gnuplot, or the
   names cannot be handed to it. An interrupt ends it, too. */
gnuplot_status_t system_gnuplot(const char *script, const char *data, const char *picture);

#endif
