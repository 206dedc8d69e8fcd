/* SPDX-License-Identifier: MIT */
#include "options.h"

#include "output.h"
#include "problem.h"

#include <stdlib.h>

static const char usage[] =
    "usage: epf_replay [RECORD.csv] [options]\n"
    "\n"
    "Runs the friction estimator over a recorded motion. Without RECORD.csv, over an example.\n"
    "\n"
    "RECORD.csv has a header row with the columns time_s and position_m, and if you like\n"
    "velocity_m_s and a measured force, friction_force_N or force_N. Others are ignored.";

enum { RECORD, FORCE_COLUMN, OUT, PICTURE, NO_PICTURE, OPTIONS };
static const option_t table[OPTIONS] = {
    [RECORD] = {"RECORD.csv", NULL, "the motion (an example)"},
    [FORCE_COLUMN] = {"--force-column", "NAME", "column of the measured force"},
    [OUT] = {"--out", "FILE", "where the result goes (replay.csv)"},
    [PICTURE] = {"--picture", "FILE", "where its picture goes (the same, .png)"},
    [NO_PICTURE] = {"--no-picture", NULL, "make none"},
};

static void choose_record(options_t *options, const char *record)
{
    options->is_example = record == NULL;
    options->record = options->is_example ? EPF_REPLAY_DIR "/example.csv" : record;
}

static bool choose_picture(options_t *options, const char *name, bool none)
{
    if (name != NULL && none) {
        return problem("command line: expected --picture or --no-picture, found both");
    }
    options->picture = (picture_t){.name = ""};
    return none || picture_choose(&options->picture, EPF_REPLAY_DIR "/plot.gp", options->out, name);
}

/* No file that is in use is written over, nor the result by its picture */
static bool check_outputs(const options_t *options)
{
    const char *const outputs[] = {options->out, picture_name(&options->picture)};
    const char *const inputs[] = {options->record, options->setup.params_file,
                                  options->picture.script};
    return output_check(outputs, sizeof outputs / sizeof outputs[0], inputs,
                        sizeof inputs / sizeof inputs[0]);
}

int options_read(options_t *options, int argc, char **argv)
{
    const char *values[OPTIONS];
    option_group_t groups[1 + SETUP_GROUPS] = {{"The files:", table, values, OPTIONS}};
    setup_options(&options->setup, groups + 1);
    const command_line_t line = {usage, groups, 1 + SETUP_GROUPS};

    const command_line_status_t status = command_line_read(&line, argc, argv);
    options->is_help = status == COMMAND_LINE_HELPED;
    if (status != COMMAND_LINE_READ) {
        return options->is_help ? EXIT_SUCCESS : EXIT_USAGE;
    }
    choose_record(options, values[RECORD]);
    options->force_column = values[FORCE_COLUMN];
    options->out = values[OUT] != NULL ? values[OUT] : "replay.csv";
    if (!choose_picture(options, values[PICTURE], values[NO_PICTURE] != NULL)) {
        return EXIT_USAGE;
    }
    const int read =
        setup_read(&options->setup, options->is_example ? EPF_REPLAY_DIR "/example.params" : NULL);
    return read == EXIT_SUCCESS && !check_outputs(options) ? EXIT_USAGE : read;
}
