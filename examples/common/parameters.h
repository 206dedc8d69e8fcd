/* SPDX-License-Identifier: MIT */
/* The parameters of the friction model and the weights of the integers, by name. */
#ifndef PARAMETERS_H
#define PARAMETERS_H

#include "command_line.h"

#include <epf/params.h>
#include <stdbool.h>

typedef enum {
    PARAMETER_SIGMA_0,
    PARAMETER_SIGMA_1,
    PARAMETER_SIGMA_2,
    PARAMETER_F_C,
    PARAMETER_F_MAX,
    PARAMETER_V_S,
    PARAMETER_Z_BA,
    PARAMETER_STRIBECK,
    PARAMETER_UPDATE,
    PARAMETER_LSB_X,
    PARAMETER_LSB_V,
    PARAMETER_LSB_F,
    PARAMETER_LSB_T,
    PARAMETERS
} parameter_t;

typedef struct {
    float value[PARAMETERS]; /* SI units; of a choice, its number in epf/params.h */
    unsigned given;          /* one bit for each that has been set */
} parameters_t;

/* Each as an option: its name with "--" before it */
extern const option_t parameters_options[PARAMETERS];

/* Sets one parameter from text. False, and the problem reported as at `place`, if the name is not
   known, has been set already, or the value will not do. The name follows the place as it stands: the
   place is "file:line: ", or "command line: --". */
bool parameters_set(parameters_t *set, const char *place, const char *name, const char *value);

/* Reads lines `name = value`, `#` begins a comment. False, and the problem reported, if anything is wrong
   with the file. */
bool parameters_read(parameters_t *set, const char *file_name);

/* Sets what has not been set yet and `more` has */
void parameters_add(parameters_t *set, const parameters_t *more);

/* Adds the defaults of the model. False, and the problem reported, if a parameter without one is missing. */
bool parameters_complete(parameters_t *set);

bool parameters_have_weights(const parameters_t *set);
void parameters_add_weights(parameters_t *set, const epf_lsb_t *weights);

/* As the library takes them, once they are complete */
epf_params_t parameters_model(const parameters_t *set);
epf_lsb_t parameters_weights(const parameters_t *set);

/* Reports why the library refuses these parameters. Returns false. */
bool parameters_refused(const parameters_t *set, epf_status_t status);

#endif
