/* SPDX-License-Identifier: MIT */
/*
 * epf_simulate: writes the example record, a mass on a surface with elasto-plastic friction.
 *
 * The continuous model of the paper, in double precision and integrated over time; nothing of the
 * library is used, so that the record is a fair test of it:
 *
 *     m dv/dt = F(t) - F_f            F_f   = sigma_0 z + sigma_1 dz/dt + sigma_2 v
 *                                     dz/dt = v (1 - alpha(z, v) z/z_ss(v))
 *
 * What is recorded is what a bench would give: the time, the position seen by an encoder, the
 * friction force seen by a load cell. The velocity is not recorded.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#ifdef __clang__
#pragma STDC FP_CONTRACT OFF /* the same digits on every machine; gcc: -std=c99 */
#endif

/* The mass, and the friction of Table II of the paper: SI units */
static const double mass = 10.0;
static const double sigma_0 = 1e5;
static const double sigma_1 = 1e3;
static const double sigma_2 = 0.4;
static const double f_c = 1.0;
static const double f_max = 1.5;
static const double v_s = 1e-3;
static const double z_ba = 8e-6;

/* The instruments */
static const double encoder_step = 10e-9; /* m */
enum { ROWS_PER_SECOND = 1000, STEPS_PER_ROW = 50 };

static const double pi = 3.14159265358979323846;

/* ---- the driving force ---------------------------------------------------------------------- */

/* Straight lines between these points */
static const struct {
    double time, force;
} drive[] = {
    {0.00, 0.0},  {1.30, 0.0},                              /* rest; a tremor, see below */
    {2.10, 1.6},  {2.12, 1.6},  {2.14, 0.0},  {2.30, 0.0},  /* slow ramp, break-away, a stop */
    {2.40, -1.6}, {2.44, -1.6}, {2.46, 0.0},  {2.60, 0.0},  /* the other way, a stop */
    {2.70, 1.6},  {2.75, 1.6},  {2.90, -1.6}, {2.94, -1.6}, /* reversal without a stop */
    {3.00, 0.4},  {4.30, 0.4},                              /* dwell under load; a tremor */
};
enum { DRIVE_POINTS = sizeof drive / sizeof drive[0] };

/* Neither leaves the elastic range: sigma_0 z_ba is 0.8 N */
static const struct {
    double start, end, amplitude, frequency;
} tremors[] = {
    {0.20, 1.20, 0.60, 5.0},
    {3.30, 4.30, 0.25, 6.0},
};
enum { TREMORS = sizeof tremors / sizeof tremors[0] };

static double driving_force(double time)
{
    int i = 1;
    while (i < DRIVE_POINTS - 1 && time >= drive[i].time) {
        i++;
    }
    const double share = (time - drive[i - 1].time) / (drive[i].time - drive[i - 1].time);
    double force = drive[i - 1].force + share * (drive[i].force - drive[i - 1].force);

    for (int k = 0; k < TREMORS; k++) {
        if (time >= tremors[k].start && time < tremors[k].end) {
            const double phase = 2.0 * pi * tremors[k].frequency * (time - tremors[k].start);
            force += tremors[k].amplitude * sin(phase);
        }
    }
    return force;
}

/* ---- the model ------------------------------------------------------------------------------ */

typedef struct {
    double x, v, z; /* position, velocity, deflection of the contact */
} state_t;

/* |z_ss(v)|, Lorentzian */
static double steady_state(double v)
{
    return ((f_max - f_c) / (1.0 + (v / v_s) * (v / v_s)) + f_c) / sigma_0;
}

static double alpha(double z, double v)
{
    const double z_ss = steady_state(v);
    if (z * v <= 0.0 || fabs(z) <= z_ba) {
        return 0.0;
    }
    if (fabs(z) >= z_ss) {
        return 1.0;
    }
    return 0.5 + 0.5 * sin(pi * ((fabs(z) - z_ba) / (z_ss - z_ba) - 0.5));
}

static double deflection_rate(const state_t *s)
{
    return s->v - alpha(s->z, s->v) * fabs(s->v) * s->z / steady_state(s->v);
}

static double friction(const state_t *s)
{
    return sigma_0 * s->z + sigma_1 * deflection_rate(s) + sigma_2 * s->v;
}

static state_t derivative(state_t s, double time)
{
    return (state_t){s.v, (driving_force(time) - friction(&s)) / mass, deflection_rate(&s)};
}

/* ---- the integration ------------------------------------------------------------------------ */

/* a + h b */
static state_t along(state_t a, double h, state_t b)
{
    return (state_t){a.x + h * b.x, a.v + h * b.v, a.z + h * b.z};
}

/* One step of the classical fourth-order Runge-Kutta method */
static state_t runge_kutta(state_t s, double time, double h)
{
    const state_t k1 = derivative(s, time);
    const state_t k2 = derivative(along(s, h / 2.0, k1), time + h / 2.0);
    const state_t k3 = derivative(along(s, h / 2.0, k2), time + h / 2.0);
    const state_t k4 = derivative(along(s, h, k3), time + h);
    s = along(s, h / 6.0, k1);
    s = along(s, h / 3.0, k2);
    s = along(s, h / 3.0, k3);
    return along(s, h / 6.0, k4);
}

/* From one row of the record to the next. Time is counted, not summed: it has no rounding drift. */
static state_t next_row(state_t s, int row, int steps)
{
    for (int i = 0; i < steps; i++) {
        const double time = ((double)row * steps + i) / ((double)steps * ROWS_PER_SECOND);
        s = runge_kutta(s, time, 1.0 / ((double)steps * ROWS_PER_SECOND));
    }
    return s;
}

/* ---- the record ----------------------------------------------------------------------------- */

static void write_row(FILE *file, int row, const state_t *s)
{
    const double seen = encoder_step * floor(s->x / encoder_step + 0.5);
    const double force = floor(friction(s) * 1e4 + 0.5) / 1e4;
    /* + 0.0 turns -0 into 0 */
    (void)fprintf(file, "%.3f,%.8f,%.4f\n", (double)row / ROWS_PER_SECOND, seen + 0.0, force + 0.0);
}

/* Writes the record. Returns how far, in m, half the step would have moved any position in it. */
static double simulate(FILE *file)
{
    const int last_row = (int)(drive[DRIVE_POINTS - 1].time * ROWS_PER_SECOND + 0.5);
    state_t s = {0.0, 0.0, 0.0};
    state_t finer = s;
    double deviation = 0.0;

    (void)fputs("time_s,position_m,friction_force_N\n", file);
    for (int row = 0; row <= last_row; row++) {
        write_row(file, row, &s);
        deviation = fmax(deviation, fabs(s.x - finer.x));
        s = next_row(s, row, STEPS_PER_ROW);
        finer = next_row(finer, row, 2 * STEPS_PER_ROW);
    }
    return deviation;
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        (void)fputs("usage: epf_simulate RECORD.csv\n", stderr);
        return 2;
    }
    FILE *file = fopen(argv[1], "wb"); /* binary: the same bytes on every system */
    if (file == NULL) {
        (void)fprintf(stderr, "epf_simulate: cannot write %s\n", argv[1]);
        return EXIT_FAILURE;
    }
    const double deviation = simulate(file);
    const int failed = ferror(file);
    if (fclose(file) != 0 || failed) {
        (void)fprintf(stderr, "epf_simulate: cannot write %s\n", argv[1]);
        return EXIT_FAILURE;
    }
    if (deviation > encoder_step / 100.0) {
        (void)fprintf(stderr, "epf_simulate: half the step moves the position by %.1e m\n",
                      deviation);
        return EXIT_FAILURE;
    }
    (void)printf("%s written; half the step moves no position by more than %.1e m\n", argv[1],
                 deviation);
    if (fflush(stdout) != 0) {
        (void)fputs("epf_simulate: stdout: cannot write everything\n", stderr);
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
