/* SPDX-License-Identifier: MIT */
/* The command line of epf_replay, and what follows from it by default. */
#ifndef OPTIONS_H
#define OPTIONS_H

#include "picture.h"
#include "setup.h"

#include <stdbool.h>

typedef struct {
    setup_t setup;
    const char *record;       /* the motion to replay */
    const char *force_column; /* NULL: the usual ones */
    const char *out;
    picture_t picture;
    bool is_example; /* no record was named: the one in the repository is replayed */
    bool is_help;    /* the help has been printed: there is no more to do */
} options_t;

/* Returns an exit status; unless it is EXIT_SUCCESS, the problem is reported */
int options_read(options_t *options, int argc, char **argv);

#endif
