/* SPDX-License-Identifier: MIT */
#include "record.h"

bool record_open(csv_record_t *record, const char *name, const char *force_column)
{
    csv_column_t columns[] = {
        [RECORD_TIME] = {"time_s", NULL, true},
        [RECORD_POSITION] = {"position_m", NULL, true},
        [RECORD_VELOCITY] = {"velocity_m_s", NULL, false},
        [RECORD_FORCE] = {"friction_force_N", "force_N", false},
    };
    if (force_column != NULL) {
        columns[RECORD_FORCE] = (csv_column_t){force_column, NULL, true};
    }
    return csv_open(record, name, columns, sizeof columns / sizeof columns[0]);
}
