/* SPDX-License-Identifier: MIT */
/* epf_figures: makes the figures of the paper and checks what it claims about them. See README.md. */
#include "claims.h"
#include "command_line.h"
#include "fidelity_table.h"
#include "figure.h"
#include "output.h"
#include "picture.h"
#include "problem.h"

#include <stdlib.h>
#include <string.h>

static const struct {
    const char *number; /* in the paper; or a name */
    figure_t *make;
    bool (*prepare)(void); /* reads what it needs; NULL: nothing */
} figures[] = {
    {"2", figure_2, NULL}, {"3", figure_3, NULL},
    {"4", figure_4, NULL}, {"5", figure_5, NULL},
    {"6", figure_6, NULL}, {"7", figure_7, NULL},
    {"8", figure_8, NULL}, {"fidelity", figure_fidelity, fidelity_table_prepare},
};
enum { FIGURES = sizeof figures / sizeof figures[0] };

static const char usage[] =
    "usage: epf_figures [options]\n"
    "\n"
    "Makes the figures of the paper, each as figure_N.csv and figure_N.png, and prints for each\n"
    "claim about them what was measured, what the limit is and whether it holds. The last,\n"
    "fidelity, is none of the paper's: how close each model comes to the continuous one.\n"
    "\n"
    "Exit status: 0 if all claims hold, 1 if a file cannot be written, 2 if the command line is\n"
    "not understood, 3 if a claim does not hold.";

enum { OUT, FIGURE, NO_PICTURES, OPTIONS };
static const option_t table[OPTIONS] = {
    [OUT] = {"--out", "DIR", "where the figures go, a folder that is there (.)"},
    [FIGURE] = {"--figure", "N", "make only this one: 2 to 8, or fidelity (all)"},
    [NO_PICTURES] = {"--no-pictures", NULL, "make the CSV files only"},
};

/* ---- files ------------------------------------------------------------------------------------ */

typedef struct {
    char data[SYSTEM_NAME_MAX + 1];
    char script[SYSTEM_NAME_MAX + 1];
    picture_t picture;
} files_t;

/* DIR/figure_N.ending. False, and the problem reported, if it is too long. */
static bool name_file(char name[SYSTEM_NAME_MAX + 1], const char *folder, const char *number,
                      const char *ending)
{
    const int length =
        snprintf(name, SYSTEM_NAME_MAX + 1, "%s/figure_%s.%s", folder, number, ending);
    return (length > 0 && length <= SYSTEM_NAME_MAX) ||
           problem("command line: --out: expected a shorter name, " FOUND, folder);
}

static bool is_asked_for(int i, const char *values[OPTIONS])
{
    return values[FIGURE] == NULL || strcmp(values[FIGURE], figures[i].number) == 0;
}

static bool name_files(files_t *files, int i, const char *values[OPTIONS])
{
    const char *folder = values[OUT] != NULL ? values[OUT] : ".";
    const char *number = figures[i].number;
    const bool is_drawn = is_asked_for(i, values) && values[NO_PICTURES] == NULL;
    return name_file(files->data, folder, number, "csv") &&
           name_file(files->script, EPF_FIGURES_DIR, number, "gp") &&
           (!is_drawn || picture_choose(&files->picture, files->script, files->data, NULL));
}

/* No file that is read is written over, nor one figure by another */
static bool check_files(const files_t files[FIGURES], const char *values[OPTIONS])
{
    const char *outputs[2 * FIGURES];
    const char *inputs[FIGURES + 2] = {EPF_FIGURES_DIR "/style.gp", EPF_BENCH_BASELINE};
    size_t n_outputs = 0;
    for (int i = 0; i < FIGURES; i++) {
        inputs[2 + i] = files[i].script;
        if (is_asked_for(i, values)) {
            outputs[n_outputs++] = files[i].data;
            outputs[n_outputs++] = picture_name(&files[i].picture);
        }
    }
    return output_check(outputs, n_outputs, inputs, FIGURES + 2);
}

/* False, and the problem reported, if a file cannot be where it belongs */
static bool choose_files(files_t files[FIGURES], const char *values[OPTIONS])
{
    for (int i = 0; i < FIGURES; i++) {
        if (!name_files(&files[i], i, values)) {
            return false;
        }
    }
    return check_files(files, values);
}

/* ---- figures ---------------------------------------------------------------------------------- */

/* False, and the problem reported, before anything is made: a long run does not end in it */
static bool prepare(const char *values[OPTIONS])
{
    for (int i = 0; i < FIGURES; i++) {
        if (is_asked_for(i, values) && figures[i].prepare != NULL && !figures[i].prepare()) {
            return false;
        }
    }
    return true;
}

static bool make(int i, const files_t *files, claims_t *claims)
{
    output_t csv;
    if (!output_open(&csv, files->data)) {
        return false;
    }
    claims->figure = figures[i].number;
    figures[i].make(csv.file, claims);
    return output_commit(&csv) && picture_make(&files->picture);
}

static bool is_figure(const char *values[OPTIONS])
{
    for (int i = 0; i < FIGURES; i++) {
        if (is_asked_for(i, values)) {
            return true;
        }
    }
    return problem("command line: --figure: expected 2 to 8 or fidelity, " FOUND, values[FIGURE]);
}

/* The exit status */
static int make_figures(const char *values[OPTIONS])
{
    static files_t files[FIGURES]; /* too large for some stacks */
    claims_t claims = {NULL, 0, 0};
    if (!is_figure(values) || !choose_files(files, values)) {
        return EXIT_USAGE;
    }
    if (!prepare(values)) {
        return EXIT_DATA;
    }
    for (int i = 0; i < FIGURES; i++) {
        if (is_asked_for(i, values) && !make(i, &files[i], &claims)) {
            return EXIT_DATA;
        }
    }
    return claims_hold(&claims) ? EXIT_SUCCESS : EXIT_CLAIM;
}

int main(int argc, char **argv)
{
    problem_from("epf_figures");
    const char *values[OPTIONS];
    const option_group_t group = {"Options:", table, values, OPTIONS};
    const command_line_t line = {usage, &group, 1};
    const command_line_status_t status = command_line_read(&line, argc, argv);
    if (status == COMMAND_LINE_FAILED) {
        return EXIT_USAGE;
    }
    return output_finish(status == COMMAND_LINE_HELPED ? EXIT_SUCCESS : make_figures(values));
}
