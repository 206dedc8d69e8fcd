/* SPDX-License-Identifier: MIT */
/* Contacts for all tests: those of the paper, and the corners of the parameter space. */
#ifndef EPF_TESTS_PARAMETER_SETS_H
#define EPF_TESTS_PARAMETER_SETS_H

#include "epf/params.h"

typedef struct {
    const char *name;
    epf_params_t params;
} parameter_set_t;

enum { PARAMETER_SETS = 9 };

extern const parameter_set_t parameter_sets[PARAMETER_SETS];

enum { UPDATE_RULES = 2 };

/* The parameters of a contact, but for the update rule */
epf_params_t parameters_by(epf_update_t rule, const parameter_set_t *set);

#endif
