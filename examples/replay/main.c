/* SPDX-License-Identifier: MIT */
/* epf_replay: runs the friction estimator over a recorded motion. See README.md. */
#include "options.h"
#include "output.h"
#include "picture.h"
#include "problem.h"
#include "record.h"
#include "replay.h"
#include "report.h"

#include <stdio.h>
#include <stdlib.h>

/* Weights by default. Bad parameters have none; the library is about to refuse them. */
static void add_default_weights(parameters_t *parameters, const variant_t *variant)
{
    if (variant->format != NULL && epf_params_check(&parameters->values) == EPF_OK) {
        const epf_lsb_t lsb = variant_default_lsb(variant, &parameters->values);
        parameters_complete_lsb(parameters, &lsb);
    }
}

/* The parameters come from the command line, then from a file, then from the defaults */
static int collect_parameters(options_t *options)
{
    parameters_t *const parameters = &options->parameters;
    if (options->params_file != NULL && !parameters_read(parameters, options->params_file)) {
        return EXIT_DATA;
    }
    if (!parameters_complete(parameters)) {
        return EXIT_USAGE;
    }
    add_default_weights(parameters, options->variant);
    return EXIT_SUCCESS;
}

/* Row in, estimate out, until the record ends. False after a problem in it. */
static bool run(replay_t *replay, csv_record_t *record, FILE *result)
{
    csv_row_t row;
    csv_status_t status;
    report_header(result, replay->setup.has_force);
    while ((status = csv_next(record, &row)) == CSV_ROW) {
        const replay_sample_t sample = replay_row(replay, &row);
        report_row(result, &sample, replay->setup.has_force);
    }
    return status == CSV_END;
}

/* Runs the whole record into the output file, which is there only if all went well */
static int write_result(replay_t *replay, csv_record_t *record, const char *out)
{
    output_t output;
    if (!output_open(&output, out)) {
        return EXIT_DATA;
    }
    if (!run(replay, record, output.file)) {
        output_discard(&output);
        return EXIT_DATA;
    }
    return output_commit(&output) ? EXIT_SUCCESS : EXIT_DATA;
}

static int replay_record(replay_t *replay, const options_t *options)
{
    csv_record_t record;
    if (!record_open(&record, options->record, options->force_column)) {
        return EXIT_DATA;
    }
    const parameters_t *parameters = &options->parameters;
    const replay_setup_t setup = {options->variant, parameters->values, parameters->lsb,
                                  csv_has(&record, RECORD_VELOCITY),
                                  csv_has(&record, RECORD_FORCE)};
    const epf_status_t status = replay_start(replay, &setup);
    int result = EXIT_USAGE;
    if (status == EPF_OK) {
        result = write_result(replay, &record, options->out);
    } else {
        parameters_refused(parameters, status);
    }
    csv_close(&record);
    return result;
}

static void show(const replay_t *replay, const options_t *options)
{
    (void)printf("record            %s\n", options->record);
    if (options->example) {
        (void)puts("                  simulated record, see examples/replay/README.md");
    }
    report_summary(replay);
    (void)printf("written           %s\n", options->out);
    if (options->picture == NULL) {
        return;
    }
    if (picture_draw(options_script, options->out, options->picture)) {
        (void)printf("written           %s\n", options->picture);
    } else {
        (void)fputs("no picture; try:  ", stdout);
        picture_print_command(options_script, options->out, options->picture);
    }
}

static int replay_and_show(options_t *options)
{
    int result = collect_parameters(options);
    replay_t replay;
    if (result == EXIT_SUCCESS) {
        result = replay_record(&replay, options);
    }
    if (result == EXIT_SUCCESS) {
        show(&replay, options);
    }
    return result;
}

int main(int argc, char **argv)
{
    problem_from("epf_replay");
    options_t options;
    if (!options_read(&options, argc, argv)) {
        return EXIT_USAGE;
    }
    int result = EXIT_SUCCESS;
    if (options.help) {
        options_print_help();
    } else {
        result = replay_and_show(&options);
    }
    if (result == EXIT_SUCCESS && !output_finish_stdout()) {
        result = EXIT_DATA;
    }
    return result;
}
