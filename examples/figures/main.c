/* SPDX-License-Identifier: MIT */
/* epf_figures: makes the figures of the paper and checks what it claims about them. See README.md. */
#include "claims.h"
#include "command_line.h"
#include "figure.h"
#include "output.h"
#include "picture.h"
#include "problem.h"

#include <stdlib.h>
#include <string.h>

static const struct {
    const char *number; /* in the paper; or a name */
    figure_t *make;
} figures[] = {
    {"2", figure_2}, {"3", figure_3}, {"4", figure_4}, {"5", figure_5},
    {"6", figure_6}, {"7", figure_7}, {"8", figure_8}, {"fidelity", figure_fidelity},
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

/* DIR/figure_N.ending. False, and the problem reported, if it is too long. */
static bool name_file(char name[SYSTEM_NAME_MAX + 1], const char *folder, const char *number,
                      const char *ending)
{
    const int length =
        snprintf(name, SYSTEM_NAME_MAX + 1, "%s/figure_%s.%s", folder, number, ending);
    return (length > 0 && length <= SYSTEM_NAME_MAX) ||
           problem("command line: --out: expected a shorter name, " FOUND, folder);
}

static bool make(int i, const char *values[OPTIONS], claims_t *claims)
{
    const char *number = figures[i].number;
    const char *folder = values[OUT] != NULL ? values[OUT] : ".";
    char data[SYSTEM_NAME_MAX + 1];
    char picture[SYSTEM_NAME_MAX + 1];
    char script[SYSTEM_NAME_MAX + 1];
    output_t csv;
    if (!name_file(data, folder, number, "csv") || !name_file(picture, folder, number, "png") ||
        !name_file(script, EPF_FIGURES_DIR, number, "gp") || !output_open(&csv, data)) {
        return false;
    }
    claims->figure = number;
    figures[i].make(csv.file, claims);
    if (!output_commit(&csv)) {
        return false;
    }
    if (values[NO_PICTURES] == NULL) {
        picture_make(script, data, picture);
    }
    return true;
}

/* The exit status */
static int make_figures(const char *values[OPTIONS])
{
    claims_t claims = {NULL, 0, 0};
    int made = 0;
    for (int i = 0; i < FIGURES; i++) {
        if (values[FIGURE] == NULL || strcmp(values[FIGURE], figures[i].number) == 0) {
            if (!make(i, values, &claims)) {
                return EXIT_DATA;
            }
            made++;
        }
    }
    if (made == 0) {
        (void)problem("command line: --figure: expected 2 to 8 or fidelity, " FOUND,
                      values[FIGURE]);
        return EXIT_USAGE;
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
