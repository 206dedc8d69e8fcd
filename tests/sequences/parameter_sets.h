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

#endif
