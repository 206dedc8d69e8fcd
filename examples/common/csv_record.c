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

static bool found_twice(const csv_record_t *record, const char *name, size_t one, size_t other)
{
    problem("%s:%lu: column %s: expected once, found as columns %lu and %lu", record->text.name,
            record->text.number, name, (unsigned long)one + 1, (unsigned long)other + 1);
    return false;
}

/* Looks for a name in the header row, and counts its cells. `place` becomes CSV_ABSENT if the name is
   not there. False, and the problem reported, if it is there twice or the row is not well formed. */
static bool find_name(csv_record_t *record, const char *name, size_t *place)
{
    char header[TEXT_LINE_MAX + 1]; /* the cells are cut out of a copy: other names follow */
    memcpy(header, record->text.line, strlen(record->text.line) + 1);
    *place = CSV_ABSENT;
    record->cells = 0;
    for (char *rest = header; rest != NULL; record->cells++) {
        const char *found = next_cell(&rest);
        if (found == NULL) {
            return bad_quotation(record, record->cells);
        }
        if (strcmp(found, name) == 0 && *place != CSV_ABSENT) {
            return found_twice(record, name, *place, record->cells);
        }
        if (strcmp(found, name) == 0) {
            *place = record->cells;
        }
    }
    return true;
}

static bool is_missing(const csv_record_t *record, const char *name)
{
    problem("%s:%lu: column %s: expected in the header row, found none of that name (of %lu)",
            record->text.name, record->text.number, name, (unsigned long)record->cells);
    return true;
}

static bool find_column(csv_record_t *record, size_t i)
{
    csv_column_t *const column = &record->columns[i];
    bool good = find_name(record, column->name, &record->place[i]);
    if (good && !csv_has(record, i) && column->otherwise != NULL) {
        column->name = column->otherwise;
        good = find_name(record, column->name, &record->place[i]);
    }
    return good &&
           (csv_has(record, i) || !column->is_required || !is_missing(record, column->name));
}

static bool read_header(csv_record_t *record)
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
    bool good = true;
    for (size_t i = 0; good && i < record->count; i++) {
        good = find_column(record, i);
    }
    return good;
}

bool csv_open(csv_record_t *record, const char *name, const csv_column_t *columns, size_t count)
{
    memcpy(record->columns, columns, count * sizeof *columns);
    record->count = count;
    record->rows = 0;
    if (!text_open(&record->text, name)) {
        return false;
    }
    if (!read_header(record)) {
        csv_close(record);
        return false;
    }
    return true;
}

bool csv_has(const csv_record_t *record, size_t column)
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
static bool split_row(csv_record_t *record, const char *cells[CSV_COLUMNS_MAX])
{
    size_t count = 0;
    char *rest = record->text.line;
    do { /* even an empty line has one cell */
        const char *cell = next_cell(&rest);
        if (cell == NULL) {
            return bad_quotation(record, count);
        }
        for (size_t i = 0; i < record->count; i++) {
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

static bool read_cells(const csv_record_t *record, const char *cells[CSV_COLUMNS_MAX],
                       csv_row_t *row)
{
    *row = (csv_row_t){{0.0}};
    for (size_t i = 0; i < record->count; i++) {
        if (csv_has(record, i) && !text_number(cells[i], &row->value[i])) {
            problem("%s:%lu: column %s: expected a finite number, " FOUND, record->text.name,
                    record->text.number, record->columns[i].name, cells[i]);
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
                record->text.name, record->text.number, record->columns[CSV_TIME].name,
                record->last_time, time);
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
    const char *cells[CSV_COLUMNS_MAX] = {NULL};
    if (!split_row(record, cells) || !read_cells(record, cells, row) ||
        !check_time(record, row->value[CSV_TIME])) {
        return CSV_FAILED;
    }
    record->rows++;
    return CSV_ROW;
}
