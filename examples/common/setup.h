/* SPDX-License-Identifier: MIT */
/*
 * Which estimator a user wants, and of which friction: the variant, the parameters, the weights of the
 * integers. The command line comes first, then a file of parameters, then the defaults.
 */
#ifndef SETUP_H
#define SETUP_H

#include "command_line.h"
#include "parameters.h"
#include "variant.h"

enum { SETUP_VARIANT, SETUP_PARAMS, SETUP_OPTIONS };
enum { SETUP_GROUPS = 2 };

typedef struct {
    const variant_t *variant;
    const char *params_file; /* NULL: none */
    parameters_t parameters;
    const char *values[SETUP_OPTIONS]; /* as on the command line */
    const char *parameter_values[PARAMETERS];
} setup_t;

/* The options, as groups of a command line. Their values go into `setup`, which needs no other start. */
void setup_options(setup_t *setup, option_group_t groups[SETUP_GROUPS]);

/* To be called once the command line is read. The file of parameters is the one that it names, or else
   `default_file`; NULL for none. Returns an exit status; unless it is EXIT_SUCCESS, the problem is
   reported. */
int setup_read(setup_t *setup, const char *default_file);

/* Starts an estimator of that variant and friction. False, and the problem reported, if the library
   refuses the parameters. */
bool setup_start(const setup_t *setup, estimator_t *estimator);

#endif
