/* SPDX-License-Identifier: MIT */
#include "csv_record.h"

#include "problem.h"

#include <string.h>

/* ---- cells ---------------------------------------------------------------------------------- */

/* Ends the quoted cell that begins at `quoted`, with "" for a quote in it. Returns what follows the
   closing quote; NULL if there is none. */
static char *unquote(char *quoted)
{
    char *to = quoted;
    for (const char *from = quoted + 1; *from != '\0'; from++) {
        if (*from == '"' && *++from != '"') {
            char *rest = quoted + (from - quoted);
            rest += strspn(rest, " \t\r");
            *to = '\0';
            return rest;
        }
        *to++ = *from;
    }
    return NULL;
}

/* Cuts the next cell off *rest, which becomes NULL after the last one. NULL for a bad quotation. */
static char *next_cell(char **rest)
{
    char *cell = *rest + strspn(*rest, " \t");
    char *end = *cell == '"' ? unquote(cell) : cell + strcspn(cell, ",");
    if (end == NULL || (*end != ',' && *end != '\0')) {
        return NULL;
    }
    *rest = *end == ',' ? end + 1 : NULL;
    *end = '\0';
    return text_trim(cell);
}

static bool bad_quotation(const csv_record_t *record, size_t cell)
{
    problem("%s:%lu: column %lu: expected a cell that ends with its quotation mark, found none",
            record->text.name, record->text.number, (unsigned long)cell + 1);
    return false;
}

/* ---- header --------------------------------------------------------------------------------- */

/* Notes the place of a column if its name is one of those wanted */
static bool note_column(csv_record_t *record, const char *found, size_t place)
{
    for (int i = 0; i < CSV_COLUMNS; i++) {
        if (record->name[i] == NULL || strcmp(found, record->name[i]) != 0) {
            continue;
        }
        if (record->place[i] != CSV_ABSENT) {
            problem("%s:%lu: column %s: expected once, found as columns %lu and %lu",
                    record->text.name, record->text.number, found,
                    (unsigned long)record->place[i] + 1, (unsigned long)place + 1);
            return false;
        }
        record->place[i] = place;
    }
    return true;
}

/* Looks for the columns by their names in `header`, which it cuts up */
static bool find_columns(csv_record_t *record, char *header)
{
    for (int i = 0; i < CSV_COLUMNS; i++) {
        record->place[i] = CSV_ABSENT;
    }
    record->cells = 0;
    for (char *rest = header; rest != NULL; record->cells++) {
        const char *found = next_cell(&rest);
        if (found == NULL) {
            return bad_quotation(record, record->cells);
        }
        if (!note_column(record, found, record->cells)) {
            return false;
        }
    }
    return true;
}

static bool require_column(const csv_record_t *record, csv_column_t column)
{
    if (!csv_has(record, column)) {
        problem("%s:%lu: column %s: expected in the header row, found none of that name (of %lu)",
                record->text.name, record->text.number, record->name[column],
                (unsigned long)record->cells);
    }
    return csv_has(record, column);
}

static bool read_header(csv_record_t *record, const char *force_column)
{
    const text_status_t status = text_next(&record->text);
    if (status == TEXT_FAILED) {
        return false;
    }
    if (status == TEXT_END || *text_trim(record->text.line) == '\0') {
        problem("%s:%lu: expected a header row with the names of the columns, found %s",
                record->text.name, record->text.number,
                status == TEXT_END ? "an empty file" : "an empty line");
        return false;
    }
    record->name[CSV_TIME] = "time_s";
    record->name[CSV_POSITION] = "position_m";
    record->name[CSV_VELOCITY] = "velocity_m_s";
    record->name[CSV_FORCE] = force_column != NULL ? force_column : "friction_force_N";

    char header[TEXT_LINE_MAX + 1];
    memcpy(header, record->text.line, strlen(record->text.line) + 1);
    if (!find_columns(record, header)) {
        return false;
    }
    if (force_column == NULL && !csv_has(record, CSV_FORCE)) { /* the second choice */
        record->name[CSV_FORCE] = "force_N";
        if (!find_columns(record, record->text.line)) {
            return false;
        }
    }
    return require_column(record, CSV_TIME) && require_column(record, CSV_POSITION) &&
           (force_column == NULL || require_column(record, CSV_FORCE));
}

bool csv_open(csv_record_t *record, const char *name, const char *force_column)
{
    record->rows = 0;
    if (!text_open(&record->text, name)) {
        return false;
    }
    if (!read_header(record, force_column)) {
        csv_close(record);
        return false;
    }
    return true;
}

bool csv_has(const csv_record_t *record, csv_column_t column)
{
    return record->place[column] != CSV_ABSENT;
}

void csv_close(csv_record_t *record)
{
    text_close(&record->text);
}

/* ---- rows ----------------------------------------------------------------------------------- */

/* Cuts the line up and keeps the cells in use. The cells are counted before any is read: a wrong
   number of them explains more than what then stands in the wrong column. */
static bool split_row(csv_record_t *record, const char *cells[CSV_COLUMNS])
{
    size_t count = 0;
    char *rest = record->text.line;
    do { /* even an empty line has one cell */
        const char *cell = next_cell(&rest);
        if (cell == NULL) {
            return bad_quotation(record, count);
        }
        for (int i = 0; i < CSV_COLUMNS; i++) {
            if (record->place[i] == count) {
                cells[i] = cell;
            }
        }
        count++;
    } while (rest != NULL);
    if (count != record->cells) {
        problem("%s:%lu: expected %lu cells, as in the header, found %lu", record->text.name,
                record->text.number, (unsigned long)record->cells, (unsigned long)count);
    }
    return count == record->cells;
}

static bool read_cells(const csv_record_t *record, const char *cells[CSV_COLUMNS], csv_row_t *row)
{
    *row = (csv_row_t){{0.0}};
    for (int i = 0; i < CSV_COLUMNS; i++) {
        if (csv_has(record, (csv_column_t)i) && !text_number(cells[i], &row->value[i])) {
            problem("%s:%lu: column %s: expected a finite number, " FOUND, record->text.name,
                    record->text.number, record->name[i], cells[i]);
            return false;
        }
    }
    return true;
}

static bool check_time(csv_record_t *record, double time)
{
    if (record->rows > 0 && !(time > record->last_time)) {
        problem("%s:%lu: column %s: expected a time after that of the row before (%.15g), "
                "found %.15g",
                record->text.name, record->text.number, record->name[CSV_TIME], record->last_time,
                time);
        return false;
    }
    record->last_time = time;
    return true;
}

static csv_status_t end_of_record(const csv_record_t *record)
{
    if (record->rows < 2) {
        problem("%s:%lu: expected at least two rows below the header, found %s", record->text.name,
                record->text.number, record->rows == 0 ? "none" : "one");
        return CSV_FAILED;
    }
    return CSV_END;
}

static csv_status_t empty_line(const csv_record_t *record, unsigned long number)
{
    problem("%s:%lu: expected %lu cells, as in the header, found an empty line", record->text.name,
            number, (unsigned long)record->cells);
    return CSV_FAILED;
}

csv_status_t csv_next(csv_record_t *record, csv_row_t *row)
{
    unsigned long first_empty = 0; /* empty lines may end a file, but not stand within it */
    text_status_t status;
    while ((status = text_next(&record->text)) == TEXT_LINE &&
           record->text.line[strspn(record->text.line, " \t\r")] == '\0') {
        first_empty = first_empty != 0 ? first_empty : record->text.number;
    }
    if (status == TEXT_FAILED) {
        return CSV_FAILED;
    }
    if (status == TEXT_END) {
        return end_of_record(record);
    }
    if (first_empty != 0) {
        return empty_line(record, first_empty);
    }
    const char *cells[CSV_COLUMNS] = {NULL};
    if (!split_row(record, cells) || !read_cells(record, cells, row) ||
        !check_time(record, row->value[CSV_TIME])) {
        return CSV_FAILED;
    }
    record->rows++;
    return CSV_ROW;
}
