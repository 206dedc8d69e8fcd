/* SPDX-License-Identifier: MIT */
#include "fidelity_costs.h"

#include "csv_cell.h"
#include "text.h"

#include <string.h>

/* The columns that are read */
enum { VARIANT, FUNCTION, RULE, METRIC, CYCLES, COLUMNS };

typedef struct {
    const char *cell[COLUMNS]; /* NULL: there is none */
} row_t;

enum { NOWHERE = -1, CELLS_MAX = 64 };

typedef struct {
    int column[CELLS_MAX]; /* of ours, by the place in a row; or NOWHERE */
} layout_t;

static int column_named(const char *name)
{
    static const char *const names[COLUMNS] = {"variant", "function", "rule", "metric",
                                               "cortex-m4f"};
    for (int i = 0; i < COLUMNS; i++) {
        if (name != NULL && strcmp(name, names[i]) == 0) {
            return i;
        }
    }
    return NOWHERE;
}

static layout_t layout_of(char *header)
{
    layout_t layout;
    char *rest = header;
    for (int i = 0; i < CELLS_MAX; i++) {
        layout.column[i] = rest != NULL ? column_named(csv_next_cell(&rest)) : NOWHERE;
    }
    return layout;
}

static row_t row_of(char *line, const layout_t *layout)
{
    row_t row = {{NULL}};
    char *rest = line;
    for (int i = 0; rest != NULL && i < CELLS_MAX; i++) {
        const char *cell = csv_next_cell(&rest);
        if (layout->column[i] != NOWHERE) {
            row.cell[layout->column[i]] = cell;
        }
    }
    return row;
}

static bool is_in(const layout_t *layout, int column)
{
    for (int i = 0; i < CELLS_MAX; i++) {
        if (layout->column[i] == column) {
            return true;
        }
    }
    return false;
}

static bool has_all_columns(const layout_t *layout)
{
    bool all = true;
    for (int column = 0; column < COLUMNS; column++) {
        all = all && is_in(layout, column);
    }
    return all;
}

static bool is(const row_t *row, int column, const char *wanted)
{
    return row->cell[column] != NULL && wanted != NULL && strcmp(row->cell[column], wanted) == 0;
}

static unsigned long cycles_of(const row_t *row)
{
    double cycles = 0.0;
    return row->cell[CYCLES] != NULL && text_number(row->cell[CYCLES], &cycles)
               ? (unsigned long)cycles
               : 0;
}

static void note(step_cost_t costs[], size_t count, const row_t *row)
{
    if (!is(row, FUNCTION, "step") || !is(row, METRIC, "cost")) {
        return;
    }
    const unsigned long cycles = cycles_of(row);
    for (size_t i = 0; i < count; i++) {
        if (is(row, VARIANT, costs[i].variant) && is(row, RULE, costs[i].rule) &&
            cycles > costs[i].cycles) {
            costs[i].cycles = cycles;
        }
    }
}

static bool read_rows(step_cost_t costs[], size_t count, text_t *text)
{
    text_status_t status = text_next(text);
    if (status == TEXT_FAILED) {
        return false;
    }
    const layout_t layout = layout_of(text->line);
    if (!has_all_columns(&layout)) {
        return text_problem(text, "expected the columns variant, function, rule, metric and "
                                  "cortex-m4f");
    }
    while ((status = text_next(text)) == TEXT_LINE) {
        const row_t row = row_of(text->line, &layout);
        note(costs, count, &row);
    }
    return status == TEXT_END;
}

bool step_costs_read(step_cost_t costs[], size_t count, const char *file)
{
    text_t text;
    if (!text_open(&text, file)) {
        return false;
    }
    const bool good = read_rows(costs, count, &text);
    text_close(&text);
    return good;
}
