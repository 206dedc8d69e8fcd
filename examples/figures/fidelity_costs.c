/* SPDX-License-Identifier: MIT */
#include "fidelity_costs.h"

#include "csv_cell.h"
#include "text.h"

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

/* The columns that are read; rows are kept whose first ones are as wanted */
enum { VARIANT, FUNCTION, RULE, METRIC, KEYS, CYCLES = KEYS, COLUMNS };

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

static bool is_wanted(const row_t *row, const char *const wanted[KEYS])
{
    for (int i = 0; i < KEYS; i++) {
        if (row->cell[i] == NULL || strcmp(row->cell[i], wanted[i]) != 0) {
            return false;
        }
    }
    return true;
}

static unsigned long cycles_of(const row_t *row)
{
    double cycles = 0.0;
    return row->cell[CYCLES] != NULL && text_number(row->cell[CYCLES], &cycles)
               ? (unsigned long)cycles
               : 0;
}

unsigned long step_cycles(const char *file, const char *variant, const char *rule)
{
    const char *const wanted[KEYS] = {
        [VARIANT] = variant, [FUNCTION] = "step", [RULE] = rule, [METRIC] = "cost"};
    unsigned long worst = 0;
    text_t text;
    if (!text_open(&text, file)) {
        return 0;
    }
    if (text_next(&text) == TEXT_LINE) {
        const layout_t layout = layout_of(text.line);
        while (text_next(&text) == TEXT_LINE) {
            const row_t row = row_of(text.line, &layout);
            const unsigned long cycles = is_wanted(&row, wanted) ? cycles_of(&row) : 0;
            worst = cycles > worst ? cycles : worst;
        }
    }
    text_close(&text);
    return worst;
}
