/* SPDX-License-Identifier: MIT */
/*
 * A command line, read by tables of options, and the help, printed from the same tables. An option may be
 * given once; its value is text, which whoever wants the option turns into numbers. Every program has
 * --help.
 */
#ifndef COMMAND_LINE_H
#define COMMAND_LINE_H

#include <stdbool.h>
#include <stddef.h>

enum { OPTION_LENGTH_MAX = 1000 };

typedef struct {
    const char *name;  /* "--out"; of an argument that stands alone, what it is: "RECORD.csv" */
    const char *takes; /* what follows the name: "FILE"; NULL: nothing follows, it is a switch */
    const char *help;  /* may have several lines */
} option_t;

/* Options of one concern: a paragraph of the help */
typedef struct {
    const char *title;
    const option_t *options;
    const char **values; /* gets the text of each option, or NULL; of a switch, its name */
    size_t count;
} option_group_t;

typedef struct {
    const char *usage; /* what the help begins with */
    const option_group_t *groups;
    size_t count;
} command_line_t;

typedef enum { COMMAND_LINE_READ, COMMAND_LINE_HELPED, COMMAND_LINE_FAILED } command_line_status_t;

/* Reads the arguments into the values of the groups. At --help it prints the help on stdout and reads no
   further. COMMAND_LINE_FAILED, and the problem reported, if an argument is not understood. */
command_line_status_t command_line_read(const command_line_t *line, int argc, char **argv);

#endif
