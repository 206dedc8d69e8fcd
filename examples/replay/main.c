/* SPDX-License-Identifier: MIT */
/* epf_replay: runs the friction estimator over a recorded motion. See README.md. */
#include "options.h"
#include "output.h"
#include "problem.h"
#include "progress.h"
#include "replay.h"
#include "report.h"

#include <stdio.h>
#include <stdlib.h>

/* Row in, estimate out, until the record ends. False after a problem in it. A stream may be the terminal
   itself, where progress would stand between the rows. */
static bool run(replay_t *replay, csv_record_t *record, const output_t *result)
{
    csv_row_t row;
    csv_status_t status;
    report_header(result->file, replay->has_force);
    while ((status = csv_next(record, &row)) == CSV_ROW) {
        const replay_sample_t sample = replay_row(replay, &row);
        report_row(result->file, &sample, replay->has_force);
        if (!result->is_stream) {
            progress_show("row %lu", replay->summary.rows);
        }
    }
    progress_end();
    return status == CSV_END;
}

/* Runs the whole record into the output file, which is there only if all went well */
static int write_result(replay_t *replay, csv_record_t *record, const char *out)
{
    output_t output;
    if (!output_open(&output, out)) {
        return EXIT_DATA;
    }
    if (!run(replay, record, &output)) {
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
    const int result = replay_start(replay, &options->setup, &record)
                           ? write_result(replay, &record, options->out)
                           : EXIT_USAGE;
    csv_close(&record);
    return result;
}

static void show(const replay_t *replay, const options_t *options)
{
    (void)printf("record            %s\n", options->record);
    if (options->is_example) {
        (void)puts("                  simulated record, see examples/replay/README.md");
    }
    report_summary(replay);
    (void)printf("written           %s\n", options->out);
}

static int replay_and_show(const options_t *options)
{
    replay_t replay;
    const int result = replay_record(&replay, options);
    if (result != EXIT_SUCCESS) {
        return result;
    }
    show(&replay, options);
    return picture_make(&options->picture) ? EXIT_SUCCESS : EXIT_DATA;
}

int main(int argc, char **argv)
{
    problem_from("epf_replay");
    options_t options;
    int result = options_read(&options, argc, argv);
    if (result == EXIT_SUCCESS && !options.is_help) {
        result = replay_and_show(&options);
    }
    return output_finish(result);
}
