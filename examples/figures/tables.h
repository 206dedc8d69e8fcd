/* SPDX-License-Identifier: MIT */
/* The parameters of the paper, and as the library takes them */
#ifndef TABLES_H
#define TABLES_H

#include "friction.h"

#include <epf/params.h>

extern const friction_t table_1; /* with a mass of 1 kg */
extern const friction_t table_2; /* with a mass of 10 kg */

epf_params_t params_of(const friction_t *friction, epf_update_t update);

/* "saturated", "mean value" */
const char *update_name(epf_update_t update);

/* Lengths are printed in micrometres */
#define MICRO 1e-6

#endif
