/* SPDX-License-Identifier: MIT */
/* Fig. 5 of the paper: alpha(z, v), eq. (10): elastic up to z_ba, mixed up to z_ss(v), then plastic */
#include "coefficients.h"
#include "errors.h"
#include "figure.h"
#include "larger.h"
#include "tables.h"

#include <math.h>

enum { HALF_ROWS = 800, SPEEDS = 3 };
static const double widest = 16e-6; /* m */

/* In v_s: hardly moving, where z_ss is near z_max; between; fast, where it is near z_c */
static const double speeds[SPEEDS] = {1e-3, 1.0, 100.0};

/* Largest distances from the equation, and how much alpha there is where there should be none */
typedef struct {
    double f32, q31, q15, where_elastic;
} distances_t;

/* The larger of the two: the distance from the equation, or what it has been */
static double further(double distance, double z, double v, double alpha)
{
    const double along = v < 0.0 ? -z : z;
    return larger(distance, fabs(alpha - friction_alpha(&friction_table_2, along,
                                                        friction_z_ss(&friction_table_2, v))));
}

/* Each variant is asked at a deflection and a velocity that it can tell exactly */
static void compare_f32(const coefficients_t *as, double z, double v, distances_t *worst)
{
    const float exact_z = (float)z;
    const float exact_v = (float)v;
    const double alpha = (double)epf_f32_alpha(&as->f32, exact_z, exact_v);
    worst->f32 = further(worst->f32, (double)exact_z, (double)exact_v, alpha);
    if ((v < 0.0 ? -z : z) < 0.9999 * friction_table_2.z_ba) {
        worst->where_elastic = larger(worst->where_elastic, alpha);
    }
}

static void compare_q31(const coefficients_t *as, double z, double v, distances_t *worst)
{
    const double unit = ldexp((double)as->lsb_q31.x, -as->q31.z_shift);
    const int32_t units = (int32_t)lround(z / unit);
    const int32_t counts = (int32_t)lround(v / (double)as->lsb_q31.v);
    worst->q31 = further(worst->q31, units * unit, counts * (double)as->lsb_q31.v,
                         ldexp(epf_q31_alpha(&as->q31, units, counts), -30));
}

/* To q15 the slowest velocity is none */
static void compare_q15(const coefficients_t *as, double z, double v, distances_t *worst)
{
    const double unit = ldexp((double)as->lsb_q15.x, -as->q15.z_shift);
    const int32_t units = (int32_t)lround(z / unit);
    const int16_t counts = (int16_t)lround(v / (double)as->lsb_q15.v);
    if (counts != 0) {
        worst->q15 = further(worst->q15, units * unit, counts * (double)as->lsb_q15.v,
                             ldexp(epf_q15_alpha(&as->q15, units, counts), -30));
    }
}

static void compare(const coefficients_t *as, double z, double v, distances_t *worst)
{
    compare_f32(as, z, v, worst);
    compare_q31(as, z, v, worst);
    compare_q15(as, z, v, worst);
}

static void write_row(FILE *csv, const coefficients_t *as, double z)
{
    (void)fprintf(csv, "%.9g", z / MICRO);
    for (int i = 0; i < SPEEDS; i++) {
        const double v = speeds[i] * friction_table_2.v_s;
        (void)fprintf(csv, ",%.9g", (double)epf_f32_alpha(&as->f32, (float)z, (float)v));
    }
    const double back = -speeds[0] * friction_table_2.v_s;
    (void)fprintf(csv, ",%.9g\n", (double)epf_f32_alpha(&as->f32, (float)z, (float)back));
}

void figure_5(FILE *csv, claims_t *claims)
{
    const coefficients_t as = coefficients_of(&friction_table_2);
    distances_t worst = {0.0, 0.0, 0.0, 0.0};
    (void)fputs("z_um,slow,at_v_s,fast,slow_towards_minus_x\n", csv);
    for (int row = -HALF_ROWS; row <= HALF_ROWS; row++) {
        const double z = widest * row / HALF_ROWS;
        write_row(csv, &as, z);
        for (int i = 0; i < SPEEDS; i++) {
            compare(&as, z, speeds[i] * friction_table_2.v_s, &worst);
            compare(&as, z, -speeds[i] * friction_table_2.v_s, &worst);
        }
    }
    claim_at_most(claims, 1e6 * worst.f32, 2.0, "ppm", "f32: alpha(z, v) is that of eq. (10)");
    claim_at_most(claims, 1e6 * worst.q31, 2.0, "ppm", "q31: the same");
    claim_at_most(claims, 1e6 * worst.q15, 1000.0, "ppm", "q15: the same");
    claim_at_most(claims, 1e6 * worst.where_elastic, 0.0, "ppm",
                  "f32: largest alpha up to z_ba, and where z and v differ in sign");
}
