/* SPDX-License-Identifier: MIT */
/* Fig. 2 of the paper: the steady-state friction force f_ss(v), eqs. (6) to (8) */
#include "coefficients.h"
#include "errors.h"
#include "figure.h"
#include "larger.h"
#include "tables.h"

#include <math.h>

enum { FORMS = 3, HALF_ROWS = 500 };
static const double widest = 5.0; /* v_s */

/* In the order of the columns */
static const friction_form_t forms[FORMS] = {FRICTION_COULOMB, FRICTION_GAUSSIAN,
                                             FRICTION_LORENTZIAN};

typedef struct {
    friction_t friction;
    coefficients_t as;
} form_t;

/* Largest distances from the equations, and from an odd function, N */
typedef struct {
    double f32, q31, q15, odd;
} distances_t;

static form_t form_of(friction_form_t form)
{
    form_t made = {.friction = friction_table_2};
    made.friction.form = form;
    made.as = coefficients_of(&made.friction);
    return made;
}

/* The larger of the two: the distance from the equation, or what it has been */
static double further(double distance, const form_t *form, double v, double f_ss)
{
    return larger(distance, fabs(f_ss - friction_f_ss(&form->friction, v)));
}

/* Each variant is asked at a velocity that it can tell exactly */
static void compare(const form_t *form, double v, distances_t *worst)
{
    const float exact = (float)v;
    const double f32 = (double)epf_f32_fss(&form->as.f32, exact);
    worst->f32 = further(worst->f32, form, (double)exact, f32);
    worst->odd = larger(worst->odd, fabs(f32 + (double)epf_f32_fss(&form->as.f32, -exact)));

    const epf_lsb_t *q31 = &form->as.lsb_q31;
    const int32_t v_q31 = (int32_t)lround(v / (double)q31->v);
    worst->q31 = further(worst->q31, form, v_q31 * (double)q31->v,
                         epf_q31_fss(&form->as.q31, v_q31) * (double)q31->f);

    const epf_lsb_t *q15 = &form->as.lsb_q15;
    const int16_t v_q15 = (int16_t)lround(v / (double)q15->v);
    worst->q15 = further(worst->q15, form, v_q15 * (double)q15->v,
                         epf_q15_fss(&form->as.q15, v_q15) * (double)q15->f);
}

static void write_row(FILE *csv, const form_t made[FORMS], double v)
{
    (void)fprintf(csv, "%.9g", v / friction_table_2.v_s);
    for (int i = 0; i < FORMS; i++) {
        (void)fprintf(csv, ",%.9g", (double)epf_f32_fss(&made[i].as.f32, (float)v));
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
        const double v = friction_table_2.v_s * widest * row / HALF_ROWS;
        write_row(csv, made, v);
        for (int i = 0; i < FORMS; i++) {
            compare(&made[i], v, &worst);
        }
    }
    const double ppm = 1e6 / friction_table_2.f_max;
    claim_at_most(claims, ppm * worst.f32, 0.2, "ppm of f_max",
                  "f32: f_ss(v) is that of eqs. (6) to (8), in all forms");
    claim_at_most(claims, ppm * worst.q31, 1.5, "ppm of f_max", "q31: the same");
    claim_at_most(claims, ppm * worst.q15, 500.0, "ppm of f_max", "q15: the same");
    claim_at_most(claims, worst.odd, 0.0, "N", "f_ss(-v) = -f_ss(v), exactly");
}
