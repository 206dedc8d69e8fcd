/* SPDX-License-Identifier: MIT */
#include "fidelity_step.h"

#include "coefficients.h"
#include "errors.h"
#include "rules.h"
#include "tables.h"

#include <math.h>
#include <stdbool.h>

enum { STARTS = 200, SPEEDS = 3 };

/* In v_s: z_ss near z_max, between, and near z_c */
static const double speeds[SPEEDS] = {0.1, 1.0, 10.0};

/* One step in SI units; each variant is told what it can tell exactly */
typedef struct {
    double z, dx, v;
} step_t;

/* Takes the step as the variant can tell it, and says where it ends */
typedef double step_by_t(const coefficients_t *as, step_t *step);

static double step_f32(const coefficients_t *as, step_t *step)
{
    const float z = (float)step->z;
    const float dx = (float)step->dx;
    const float v = (float)step->v;
    epf_f32_t contact;
    epf_f32_init(&contact, &as->f32);
    epf_f32_reset(&contact, z);
    *step = (step_t){(double)z, (double)dx, (double)v};
    return (double)epf_f32_update(&contact, dx, v);
}

static double step_q31(const coefficients_t *as, step_t *step)
{
    const epf_lsb_t *lsb = &as->lsb_q31;
    const double unit = ldexp((double)lsb->x, -as->q31.z_shift);
    const int32_t z = (int32_t)lround(step->z / unit);
    const int32_t dx = (int32_t)lround(step->dx / (double)lsb->x);
    const int32_t v = (int32_t)lround(step->v / (double)lsb->v);
    epf_q31_t contact;
    epf_q31_init(&contact, &as->q31);
    epf_q31_reset(&contact, z);
    *step = (step_t){z * unit, dx * (double)lsb->x, v * (double)lsb->v};
    return epf_q31_update(&contact, dx, v) * unit;
}

static double step_q15(const coefficients_t *as, step_t *step)
{
    const epf_lsb_t *lsb = &as->lsb_q15;
    const double unit = ldexp((double)lsb->x, -as->q15.z_shift);
    const int32_t z = (int32_t)lround(step->z / unit);
    const int16_t dx = (int16_t)lround(step->dx / (double)lsb->x);
    const int16_t v = (int16_t)lround(step->v / (double)lsb->v);
    epf_q15_t contact;
    epf_q15_init(&contact, &as->q15);
    epf_q15_reset(&contact, z);
    *step = (step_t){z * unit, dx * (double)lsb->x, v * (double)lsb->v};
    return epf_q15_update(&contact, dx, v) * unit;
}

/* ---- the steps ---------------------------------------------------------------------------------- */

enum { VARIANTS = 3 };
static const struct {
    const char *name;
    step_by_t *step;
} variants[VARIANTS] = {{"f32", step_f32}, {"q31", step_q31}, {"q15", step_q15}};

/* Of z_ss: where a step begins. From below the contact gives way, from above it lets go. */
enum { BELOW, ABOVE, SIDES };

/* Limits are a few percent above what the rule reaches, so that other constants in it fail one of them */
static const struct {
    int side;
    double size, limit;
} sizes[] = {
    {BELOW, 0.1, 1.2e-4}, {BELOW, 0.3, 1.2e-3}, {BELOW, 1.0, 9e-3},
    {BELOW, 3.0, 0.135},  {ABOVE, 1.0, 1.8e-3},
};
enum { SIZES = sizeof sizes / sizeof sizes[0] };

/* In what a step is told, and how far it is off */
static const struct {
    const char *begins, *size, *error;
} sides[SIDES] = {{"below", "(z_ss - z_ba)", "of the gap to z_ss"}, {"above", "z_ss", "z_ss"}};

/* Takes one step, the share of the way from z_ba or z_max to z_ss, and adds its error */
static void add_step(errors_t *errors, const coefficients_t *as, int variant, int size, double v,
                     double share)
{
    const double z_ss = friction_z_ss(&friction_table_2, v);
    const bool above = sizes[size].side == ABOVE;
    const double from = above ? friction_z_max(&friction_table_2) : friction_table_2.z_ba;
    const double unit = above ? z_ss : z_ss - friction_table_2.z_ba;
    step_t step = {from + share * (z_ss - from), sizes[size].size * unit, v};
    const double z = variants[variant].step(as, &step);
    const double exact = rule_exact_flow(&friction_table_2, step.z, step.dx, step.v, 0.0);
    errors_add(errors, (z - exact) / (above ? z_ss : z_ss - step.z));
}

/* rms error of steps from everywhere */
static double error_of(const coefficients_t *as, int variant, int size)
{
    errors_t errors = {0.0, 0.0, 0};
    for (int i = 0; i < SPEEDS; i++) {
        for (int start = 0; start < STARTS; start++) {
            add_step(&errors, as, variant, size, speeds[i] * friction_table_2.v_s,
                     (start + 0.5) / STARTS);
        }
    }
    return errors_rms(&errors);
}

void fidelity_claim_steps(claims_t *claims)
{
    const coefficients_t as = coefficients_of(&friction_table_2);
    for (int variant = 0; variant < VARIANTS; variant++) {
        for (int size = 0; size < SIZES; size++) {
            const int side = sizes[size].side;
            claim_at_most(
                claims, error_of(&as, variant, size), sizes[size].limit, sides[side].error,
                "mean value %s, one step at constant v from %s z_ss, of %g %s: rms "
                "distance from the exact flow",
                variants[variant].name, sides[side].begins, sizes[size].size, sides[side].size);
        }
    }
}
