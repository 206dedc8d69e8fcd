/* SPDX-License-Identifier: MIT */
/* Fig. 5 of the paper: alpha(z, v), eq. (10): elastic up to z_ba, mixed up to z_ss(v), then plastic */
#include "figure.h"
#include "tables.h"
#include "variant.h"

#include <math.h>

enum { HALF_ROWS = 800, SPEEDS = 3 };

/* In v_s: hardly moving, where z_ss is near z_max; between; fast, where it is near z_c */
static const double speeds[SPEEDS] = {1e-3, 1.0, 100.0};

typedef struct {
    epf_f32_coeffs_t f32;
    epf_q31_coeffs_t q31;
    epf_q15_coeffs_t q15;
    epf_lsb_t lsb_31, lsb_15;
} coefficients_t;

/* Largest distances from the equation, and how much alpha there is where there should be none */
typedef struct {
    double f32, q31, q15, where_elastic;
} distances_t;

static double expected(double z, double v)
{
    return friction_alpha(&table_2, v < 0.0 ? -z : z, friction_z_ss(&table_2, v));
}

static void compare_f32(const coefficients_t *made, double z, double v, distances_t *worst)
{
    const double alpha = (double)epf_f32_alpha(&made->f32, (float)z, (float)v);
    worst->f32 = fmax(worst->f32, fabs(alpha - expected((double)(float)z, (double)(float)v)));
    if ((v < 0.0 ? -z : z) <= 0.9999 * table_2.z_ba) {
        worst->where_elastic = fmax(worst->where_elastic, alpha);
    }
}

/* Asked at a deflection and a velocity that the integers can tell exactly */
static void compare_integers(const coefficients_t *made, double z, double v, distances_t *worst)
{
    const double unit_31 = ldexp((double)made->lsb_31.x, -made->q31.z_shift);
    const int32_t z_31 = (int32_t)lround(z / unit_31);
    const int32_t v_31 = (int32_t)lround(v / (double)made->lsb_31.v);
    const double q31 = ldexp(epf_q31_alpha(&made->q31, z_31, v_31), -30);
    worst->q31 =
        fmax(worst->q31, fabs(q31 - expected(z_31 * unit_31, v_31 * (double)made->lsb_31.v)));

    const double unit_15 = ldexp((double)made->lsb_15.x, -made->q15.z_shift);
    const int32_t z_15 = (int32_t)lround(z / unit_15);
    const int16_t v_15 = (int16_t)lround(v / (double)made->lsb_15.v);
    if (v_15 != 0) {
        const double q15 = ldexp(epf_q15_alpha(&made->q15, z_15, v_15), -30);
        worst->q15 =
            fmax(worst->q15, fabs(q15 - expected(z_15 * unit_15, v_15 * (double)made->lsb_15.v)));
    }
}

void figure_5(FILE *csv, claims_t *claims)
{
    const epf_params_t params = params_of(&table_2, EPF_UPDATE_MEAN_VALUE);
    coefficients_t made = {.lsb_31 = variant_default_lsb(&variant_q31, &params),
                           .lsb_15 = variant_default_lsb(&variant_q15, &params)};
    (void)epf_f32_coeffs_init(&made.f32, &params);
    (void)epf_q31_coeffs_init(&made.q31, &params, &made.lsb_31);
    (void)epf_q15_coeffs_init(&made.q15, &params, &made.lsb_15);

    distances_t worst = {0.0, 0.0, 0.0, 0.0};
    (void)fputs("z_um,slow,at_v_s,fast,slow_towards_minus_x\n", csv);
    for (int row = -HALF_ROWS; row <= HALF_ROWS; row++) {
        const double z = 16.0 * MICRO * row / HALF_ROWS;
        (void)fprintf(csv, "%.9g", z / MICRO);
        for (int i = 0; i < SPEEDS; i++) {
            const double v = speeds[i] * table_2.v_s;
            (void)fprintf(csv, ",%.9g", (double)epf_f32_alpha(&made.f32, (float)z, (float)v));
            compare_f32(&made, z, v, &worst);
            compare_f32(&made, z, -v, &worst);
            compare_integers(&made, z, v, &worst);
            compare_integers(&made, z, -v, &worst);
        }
        const double back = -speeds[0] * table_2.v_s;
        (void)fprintf(csv, ",%.9g\n", (double)epf_f32_alpha(&made.f32, (float)z, (float)back));
    }
    claim_at_most(claims, 1e6 * worst.f32, 2.0, "ppm", "f32: alpha(z, v) is that of eq. (10)");
    claim_at_most(claims, 1e6 * worst.q31, 20.0, "ppm", "q31: the same");
    claim_at_most(claims, 1e6 * worst.q15, 2000.0, "ppm", "q15: the same");
    claim_at_most(claims, 1e6 * worst.where_elastic, 0.0, "ppm",
                  "f32: largest alpha up to z_ba, and where z and v differ in sign");
}
