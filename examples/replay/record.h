/* SPDX-License-Identifier: MIT */
/* The columns of a recorded motion. The README lists them. */
#ifndef RECORD_H
#define RECORD_H

#include "csv_record.h"

/* Velocity and force need not be there */
typedef enum {
    RECORD_TIME = CSV_TIME,
    RECORD_POSITION,
    RECORD_VELOCITY,
    RECORD_FORCE
} record_column_t;

/* Opens a record. The measured force is the column `force_column`, which must then exist; for NULL it
   is friction_force_N, else force_N, else there is none. False after a problem. */
bool record_open(csv_record_t *record, const char *name, const char *force_column);

#endif
