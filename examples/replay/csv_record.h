/* SPDX-License-Identifier: MIT */
/*
 * A recorded motion, read row by row from a CSV file. Columns are found by the names in its header
 * row; others are ignored. Every row is checked: its number of cells, a finite number in each cell
 * in use, time strictly increasing. Every problem is reported here, with file, line and column.
 */
#ifndef CSV_RECORD_H
#define CSV_RECORD_H

#include "text.h"

#include <stdbool.h>
#include <stddef.h>

/* The columns in use. The last two need not be there. */
typedef enum { CSV_TIME, CSV_POSITION, CSV_VELOCITY, CSV_FORCE, CSV_COLUMNS } csv_column_t;

typedef struct {
    double value[CSV_COLUMNS]; /* SI units; 0 where there is no such column */
} csv_row_t;

typedef struct {
    text_t text;
    size_t cells;                  /* per row */
    size_t place[CSV_COLUMNS];     /* of each column, CSV_ABSENT where there is none */
    const char *name[CSV_COLUMNS]; /* as in the header */
    unsigned long rows;            /* read so far */
    double last_time;
} csv_record_t;

#define CSV_ABSENT ((size_t)-1)

typedef enum { CSV_ROW, CSV_END, CSV_FAILED } csv_status_t;

/*
 * Opens the file and reads its header. The measured force is the column `force_column`, which must
 * then exist; for NULL it is friction_force_N, else force_N, else there is none.
 * False after a problem; there is nothing to close then.
 */
bool csv_open(csv_record_t *record, const char *name, const char *force_column);

/* The next row. CSV_END only after at least two of them: one is no motion. */
csv_status_t csv_next(csv_record_t *record, csv_row_t *row);

bool csv_has(const csv_record_t *record, csv_column_t column);

void csv_close(csv_record_t *record);

#endif
