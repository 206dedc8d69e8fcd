/* SPDX-License-Identifier: MIT */
#include "csv_record.h"

#include "csv_cell.h"
#include "problem.h"

#include <string.h>

static bool bad_quotation(const csv_record_t *record, size_t cell)
{
    return text_problem(&record->text,
                        "column %lu: expected a cell that ends with its quotation mark, found none",
                        (unsigned long)cell + 1);
}

/* ---- header --------------------------------------------------------------------------------- */

/* Looks for a name in the header row, and counts its cells. `place` becomes CSV_ABSENT if the name is
   not there. False, and the problem reported, if it is there twice or the row is not well formed. */
static bool find_name(csv_record_t *record, const char *name, size_t *place)
{
    char header[TEXT_LINE_MAX + 1]; /* the cells are cut out of a copy: other names follow */
    memcpy(header, record->text.line, strlen(record->text.line) + 1);
    *place = CSV_ABSENT;
    record->cells = 0;
    for (char *rest = header; rest != NULL; record->cells++) {
        const char *found = csv_next_cell(&rest);
        if (found == NULL) {
            return bad_quotation(record, record->cells);
        }
        if (strcmp(found, name) != 0) {
            continue;
        }
        if (*place != CSV_ABSENT) {
            return text_problem(&record->text,
                                "column %s: expected once, found as columns %lu and %lu", name,
                                (unsigned long)*place + 1, (unsigned long)record->cells + 1);
        }
        *place = record->cells;
    }
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
    if (good && !csv_has(record, i) && column->is_required) {
        good =
            text_problem(&record->text,
                         "column %s: expected in the header row, found none of that name (of %lu)",
                         column->name, (unsigned long)record->cells);
    }
    return good;
}

static bool read_header(csv_record_t *record)
{
    const text_status_t status = text_next(&record->text);
    if (status == TEXT_FAILED) {
        return false;
    }
    if (status == TEXT_END || *text_trim(record->text.line) == '\0') {
        return text_problem(&record->text,
                            "expected a header row with the names of the columns, found %s",
                            status == TEXT_END ? "an empty file" : "an empty line");
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
        const char *cell = csv_next_cell(&rest);
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
    return count == record->cells ||
           text_problem(&record->text, "expected %lu cells, as in the header, found %lu",
                        (unsigned long)record->cells, (unsigned long)count);
}

static bool read_cells(const csv_record_t *record, const char *cells[CSV_COLUMNS_MAX],
                       csv_row_t *row)
{
    *row = (csv_row_t){{0.0}};
    for (size_t i = 0; i < record->count; i++) {
        if (csv_has(record, i) && !text_number(cells[i], &row->value[i])) {
            return text_problem(&record->text, "column %s: expected a finite number, " FOUND,
                                record->columns[i].name, cells[i]);
        }
    }
    return true;
}

static bool check_time(csv_record_t *record, double time)
{
    if (record->rows > 0 && !(time > record->last_time)) {
        return text_problem(
            &record->text,
            "column %s: expected a time after that of the row before (%.15g), found %.15g",
            record->columns[CSV_TIME].name, record->last_time, time);
    }
    record->last_time = time;
    return true;
}

static csv_status_t end_of_record(const csv_record_t *record)
{
    if (record->rows < 2) {
        (void)text_problem(&record->text, "expected at least two rows below the header, found %s",
                           record->rows == 0 ? "none" : "one");
        return CSV_FAILED;
    }
    return CSV_END;
}

/* Puts the next line with something in it into the text. Empty lines may end a file, but not stand
   within it. */
static text_status_t next_line(csv_record_t *record)
{
    text_t *const text = &record->text;
    unsigned long first_empty = 0;
    text_status_t status;
    while ((status = text_next(text)) == TEXT_LINE && text_is_blank(text->line)) {
        first_empty = first_empty != 0 ? first_empty : text->number;
    }
    if (status == TEXT_LINE && first_empty != 0) {
        text->number = first_empty;
        (void)text_problem(text, "expected %lu cells, as in the header, found an empty line",
                           (unsigned long)record->cells);
        return TEXT_FAILED;
    }
    return status;
}

csv_status_t csv_next(csv_record_t *record, csv_row_t *row)
{
    const char *cells[CSV_COLUMNS_MAX] = {NULL};
    const text_status_t status = next_line(record);
    if (status == TEXT_END) {
        return end_of_record(record);
    }
    if (status == TEXT_FAILED || !split_row(record, cells) || !read_cells(record, cells, row) ||
        !check_time(record, row->value[CSV_TIME])) {
        return CSV_FAILED;
    }
    record->rows++;
    return CSV_ROW;
}
