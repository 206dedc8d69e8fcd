/* SPDX-License-Identifier: MIT */
/* The parameters of the friction model, and the weights of the integers, by name, from the command line and from a file. */
#ifndef PARAMETERS_H
#define PARAMETERS_H

#include <epf/params.h>
#include <stdbool.h>

typedef struct {
    epf_params_t values;
    epf_lsb_t lsb;
    unsigned given; /* one bit for each parameter that has been set */
} parameters_t;

bool parameters_known(const char *name);

/* Sets one parameter from text. False, and the problem reported as at `place`, if the name is not
   known, has been set already, or the value will not do. */
bool parameters_set(parameters_t *set, const char *place, const char *name, const char *value);

/* Reads lines `name = value`, `#` begins a comment. What has been set before stays: the command
   line, read first, wins. False, and the problem reported, if anything is wrong with the file. */
bool parameters_read(parameters_t *set, const char *file_name);

/* True if a weight has been set */
bool parameters_have_lsb(const parameters_t *set);

/* Fills in the defaults of the model. False, and the problem reported, if a parameter without one is missing. */
bool parameters_complete(parameters_t *set);

/* Fills in these weights where none has been set */
void parameters_complete_lsb(parameters_t *set, const epf_lsb_t *defaults);

/* Reports why the library refuses these parameters */
void parameters_refused(const parameters_t *set, epf_status_t status);

#endif
