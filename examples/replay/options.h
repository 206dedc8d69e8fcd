/* SPDX-License-Identifier: MIT */
/* The command line, and what follows from it by default. */
#ifndef OPTIONS_H
#define OPTIONS_H

#include "parameters.h"
#include "variant.h"

#include <stdbool.h>

enum { OPTIONS_NAME_MAX = 1000 };

typedef struct {
    const char *record;       /* the motion to replay */
    const char *params_file;  /* NULL: none */
    const char *force_column; /* NULL: the usual ones */
    const char *variant_name;
    const variant_t *variant;
    const char *out;
    const char *picture;
    bool no_picture;
    bool help;
    bool example; /* no record was named: the one in the repository is replayed */
    parameters_t parameters;
    char picture_by_default[OPTIONS_NAME_MAX + 5];
} options_t;

/* The file that tells gnuplot how to draw */
extern const char options_script[];

/* False, and the problem reported, if the command line is not understood */
bool options_read(options_t *options, int argc, char **argv);

void options_print_help(void);

#endif
