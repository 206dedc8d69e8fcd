/* SPDX-License-Identifier: MIT */
/* The frictions of the plant, as the library takes them */
#ifndef TABLES_H
#define TABLES_H

#include "friction.h"

#include <epf/params.h>

epf_params_t params_of(const friction_t *friction, epf_update_t update);

/* "saturated", "mean value" */
const char *update_name(epf_update_t update);

/* Lengths are printed in micrometres */
#define MICRO 1e-6

#endif
