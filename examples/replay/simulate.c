/* SPDX-License-Identifier: MIT */
/*
 * epf_simulate: writes the example record, a mass on a surface with elasto-plastic friction.
 *
 * The mass and its friction are those of examples/plant: nothing of the library is used, so that the record
 * is a fair test of it. What is recorded is what a bench would give: the time, the position seen by an
 * encoder, the friction force seen by a load cell. The velocity is not recorded.
 */
#include "command_line.h"
#include "drive.h"
#include "encoder.h"
#include "output.h"
#include "problem.h"
#include "slide.h"

#include <math.h>
#include <stdlib.h>

/* Straight lines between these points */
static const drive_point_t points[] = {
    {0.00, 0.0},  {1.30, 0.0},                              /* rest; a tremor, see below */
    {2.10, 1.6},  {2.12, 1.6},  {2.14, 0.0},  {2.30, 0.0},  /* slow ramp, break-away, a stop */
    {2.40, -1.6}, {2.44, -1.6}, {2.46, 0.0},  {2.60, 0.0},  /* the other way, a stop */
    {2.70, 1.6},  {2.75, 1.6},  {2.90, -1.6}, {2.94, -1.6}, /* reversal without a stop */
    {3.00, 0.4},  {4.30, 0.4},                              /* dwell under load; a tremor */
};

/* Neither leaves the elastic range: sigma_0 z_ba is 0.8 N */
static const drive_sine_t tremors[] = {
    {0.20, 1.20, 0.60, 5.0},
    {3.30, 4.30, 0.25, 6.0},
};

enum { POINTS = sizeof points / sizeof points[0], TREMORS = sizeof tremors / sizeof tremors[0] };
static const drive_t drive = {points, POINTS, tremors, TREMORS};

/* The instruments */
static const double encoder_step = 10e-9;  /* m */
static const double load_cell_step = 1e-4; /* N */

/* How far half the step of integration may move a position, m */
static const double accuracy = 3e-12;
enum { ROWS_PER_SECOND = 1000, STEPS_PER_ROW = 50 };

static void write_row(FILE *file, encoder_t *encoder, const run_t *run)
{
    const double time = run_time(run);
    const double position = encoder_read(encoder, run->coarse.x);
    const double force = slide_friction(run->slide, &run->coarse, time);
    /* + 0.0 turns -0 into 0 */
    (void)fprintf(file, "%.3f,%.8f,%.4f\n", time, position + 0.0,
                  load_cell_step * floor(force / load_cell_step + 0.5) + 0.0);
}

/* Writes the record. Returns how far, in m, half the step would have moved any position in it. */
static double simulate(FILE *file)
{
    const int last_row = (int)(points[POINTS - 1].time * ROWS_PER_SECOND + 0.5);
    const slide_t slide = {.contact = {friction_table_2, CONTACT_ELASTO_PLASTIC},
                           .mass = 10.0,
                           .force = drive_force,
                           .context = &drive};
    const slide_state_t rest = {0.0, 0.0, 0.0};
    encoder_t encoder = {.resolution = encoder_step};
    run_t run = run_from(&slide, rest, (double)STEPS_PER_ROW * ROWS_PER_SECOND);

    (void)fputs("time_s,position_m,friction_force_N\n", file);
    for (int row = 0; row <= last_row; row++) {
        write_row(file, &encoder, &run);
        run_advance(&run, STEPS_PER_ROW);
    }
    return run.apart.x;
}

static int write_record(const char *name)
{
    output_t output;
    if (name == NULL) {
        (void)problem("command line: RECORD.csv: expected, found none");
        return EXIT_USAGE;
    }
    if (!output_open(&output, name)) {
        return EXIT_DATA;
    }
    const double apart = simulate(output.file);
    if (apart > accuracy) {
        output_discard(&output);
        (void)problem("half the step moves the position by %.1e m", apart);
        return EXIT_FAILURE;
    }
    if (!output_commit(&output)) {
        return EXIT_DATA;
    }
    (void)printf("%s written; half the step moves no position by more than %.1e m\n", name, apart);
    return EXIT_SUCCESS;
}

int main(int argc, char **argv)
{
    static const option_t table[] = {{"RECORD.csv", NULL, "where the record goes"}};
    const char *name;
    const option_group_t group = {"The files:", table, &name, 1};
    const command_line_t line = {"usage: epf_simulate RECORD.csv\n\nWrites the example record.",
                                 &group, 1};
    problem_from("epf_simulate");
    const command_line_status_t status = command_line_read(&line, argc, argv);
    if (status == COMMAND_LINE_FAILED) {
        return EXIT_USAGE;
    }
    return output_finish(status == COMMAND_LINE_HELPED ? EXIT_SUCCESS : write_record(name));
}
