/* SPDX-License-Identifier: MIT */
/*
 * A record over time, read row by row from a CSV file. Columns are found by the names in its header
 * row; others are ignored. Every row is checked: its number of cells, a finite number in each cell in
 * use, time strictly increasing. Every problem is reported here, with file, line and column.
 */
#ifndef CSV_RECORD_H
#define CSV_RECORD_H

#include "text.h"

#include <stdbool.h>
#include <stddef.h>

enum { CSV_COLUMNS_MAX = 8 };

/* A column that the program wants */
typedef struct {
    const char *name;
    const char *otherwise; /* the name to look for if there is no such column; NULL: none */
    bool is_required;
} csv_column_t;

/* The first column of every table is the time, and is required */
enum { CSV_TIME = 0 };

typedef struct {
    double value[CSV_COLUMNS_MAX]; /* in the order of the table; 0 where there is no such column */
} csv_row_t;

typedef struct {
    text_t text;
    csv_column_t columns[CSV_COLUMNS_MAX]; /* the table; each name as in the header */
    size_t count;                          /* of them */
    size_t place[CSV_COLUMNS_MAX];         /* of each in a row, CSV_ABSENT where there is none */
    size_t cells;                          /* per row */
    unsigned long rows;                    /* read so far */
    double last_time;
} csv_record_t;

#define CSV_ABSENT ((size_t)-1)

typedef enum { CSV_ROW, CSV_END, CSV_FAILED } csv_status_t;

/* Opens the file and finds the columns of a table, at most CSV_COLUMNS_MAX. The names must outlive the
   record. False after a problem; there is nothing to close then. */
bool csv_open(csv_record_t *record, const char *name, const csv_column_t *columns, size_t count);

/* The next row. CSV_END only after at least two of them: one is no motion. */
csv_status_t csv_next(csv_record_t *record, csv_row_t *row);

/* True if the column of that place in the table is there */
bool csv_has(const csv_record_t *record, size_t column);

void csv_close(csv_record_t *record);

#endif
