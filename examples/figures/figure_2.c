/* SPDX-License-Identifier: MIT */
/* Fig. 2 of the paper: the steady-state friction force f_ss(v), eqs. (6) to (8) */
#include "figure.h"
#include "tables.h"
#include "variant.h"

#include <math.h>

enum { FORMS = 3, HALF_ROWS = 500 };
static const double widest = 5.0; /* v_s */

/* In the order of the columns */
static const friction_form_t forms[FORMS] = {FRICTION_COULOMB, FRICTION_GAUSSIAN,
                                             FRICTION_LORENTZIAN};

/* The coefficients of one form in all variants, and the weights of the integers */
typedef struct {
    friction_t friction;
    epf_f32_coeffs_t f32;
    epf_q31_coeffs_t q31;
    epf_q15_coeffs_t q15;
    epf_lsb_t lsb_31, lsb_15;
} form_t;

/* Largest distances from the equations, N */
typedef struct {
    double f32, q31, q15, odd;
} distances_t;

static form_t form_of(friction_form_t form)
{
    form_t made = {.friction = table_2};
    made.friction.form = form;
    const epf_params_t params = params_of(&made.friction, EPF_UPDATE_MEAN_VALUE);
    made.lsb_31 = variant_default_lsb(&variant_q31, &params);
    made.lsb_15 = variant_default_lsb(&variant_q15, &params);
    (void)epf_f32_coeffs_init(&made.f32, &params);
    (void)epf_q31_coeffs_init(&made.q31, &params, &made.lsb_31);
    (void)epf_q15_coeffs_init(&made.q15, &params, &made.lsb_15);
    return made;
}

/* Each variant is asked at a velocity that it can tell exactly */
static void compare(const form_t *form, double v, distances_t *worst)
{
    const float exact = (float)v;
    const double f32 = (double)epf_f32_fss(&form->f32, exact);
    worst->f32 = fmax(worst->f32, fabs(f32 - friction_f_ss(&form->friction, (double)exact)));
    worst->odd = fmax(worst->odd, fabs(f32 + (double)epf_f32_fss(&form->f32, -exact)));

    const int32_t v_31 = (int32_t)lround(v / (double)form->lsb_31.v);
    const double q31 = epf_q31_fss(&form->q31, v_31) * (double)form->lsb_31.f;
    const double v_q31 = v_31 * (double)form->lsb_31.v;
    worst->q31 = fmax(worst->q31, fabs(q31 - friction_f_ss(&form->friction, v_q31)));

    const int16_t v_15 = (int16_t)lround(v / (double)form->lsb_15.v);
    const double q15 = epf_q15_fss(&form->q15, v_15) * (double)form->lsb_15.f;
    const double v_q15 = v_15 * (double)form->lsb_15.v;
    worst->q15 = fmax(worst->q15, fabs(q15 - friction_f_ss(&form->friction, v_q15)));
}

static void write_row(FILE *csv, const form_t made[FORMS], double v)
{
    (void)fprintf(csv, "%.9g", v / table_2.v_s);
    for (int i = 0; i < FORMS; i++) {
        (void)fprintf(csv, ",%.9g", (double)epf_f32_fss(&made[i].f32, (float)v));
    }
    (void)fputc('\n', csv);
}

void figure_2(FILE *csv, claims_t *claims)
{
    form_t made[FORMS];
    distances_t worst = {0.0, 0.0, 0.0, 0.0};
    for (int i = 0; i < FORMS; i++) {
        made[i] = form_of(forms[i]);
    }
    (void)fputs("v_over_v_s,coulomb_N,gaussian_N,lorentzian_N\n", csv);
    for (int row = -HALF_ROWS; row <= HALF_ROWS; row++) {
        const double v = table_2.v_s * widest * row / HALF_ROWS;
        write_row(csv, made, v);
        for (int i = 0; i < FORMS; i++) {
            compare(&made[i], v, &worst);
        }
    }
    const double ppm = 1e6 / table_2.f_max;
    claim_at_most(claims, ppm * worst.f32, 1.0, "ppm of f_max",
                  "f32: f_ss(v) is that of eqs. (6) to (8), in all forms");
    claim_at_most(claims, ppm * worst.q31, 3.0, "ppm of f_max", "q31: the same");
    claim_at_most(claims, ppm * worst.q15, 500.0, "ppm of f_max", "q15: the same");
    claim_at_most(claims, worst.odd, 0.0, "N", "f_ss(-v) = -f_ss(v), exactly");
}
