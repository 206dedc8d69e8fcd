/* SPDX-License-Identifier: MIT */
#include "fidelity_models.h"

#include "rules.h"
#include "tables.h"
#include "track.h"

#include <math.h>
#include <stddef.h>

/* Of the library, or else a rule of examples/plant */
typedef struct {
    const char *name;
    const variant_t *variant;
    epf_update_t update;
    rule_t *rule;
    measured_t measured;
} description_t;

static const description_t descriptions[MODELS] = {
    {"mean value f32", &variant_f32, EPF_UPDATE_MEAN_VALUE, NULL, {"f32", "mean_value"}},
    {"mean value q31", &variant_q31, EPF_UPDATE_MEAN_VALUE, NULL, {"q31", "mean_value"}},
    {"mean value q15", &variant_q15, EPF_UPDATE_MEAN_VALUE, NULL, {"q15", "mean_value"}},
    {"saturated f32", &variant_f32, EPF_UPDATE_SATURATED, NULL, {"f32", "saturated"}},
    {"saturated q31", &variant_q31, EPF_UPDATE_SATURATED, NULL, {"q31", "saturated"}},
    {"saturated q15", &variant_q15, EPF_UPDATE_SATURATED, NULL, {"q15", "saturated"}},
    {"exact flow", NULL, EPF_UPDATE_SATURATED, rule_exact_flow, {NULL, NULL}},
    {"mean value f32 at end velocity",
     &variant_f32,
     EPF_UPDATE_MEAN_VALUE,
     NULL,
     {"f32", "mean_value"}},
    {"Algorithm 1 as printed",
     NULL,
     EPF_UPDATE_SATURATED,
     rule_algorithm_1_as_printed,
     {"naive", "any"}},
    {"elasto-plastic by Euler",
     NULL,
     EPF_UPDATE_SATURATED,
     rule_elasto_plastic_euler,
     {"ep_euler", "any"}},
    {"LuGre by Euler", NULL, EPF_UPDATE_SATURATED, rule_lugre_euler, {"lugre_euler", "any"}},
    {"LuGre by exact hold", NULL, EPF_UPDATE_SATURATED, rule_lugre_exact, {"lugre_exact", "any"}},
};

const char *model_name(model_t model)
{
    return descriptions[model].name;
}

measured_t model_measured(model_t model)
{
    return descriptions[model].measured;
}

/* Weights so fine that it is not the encoder which is measured. Positions by default have 1e6 (q31) and
   16,000 counts (q15) per z_max, which is 15 um. */
static epf_lsb_t weights(const variant_t *variant, const epf_params_t *params, double spacing)
{
    if (variant->format == NULL) {
        return (epf_lsb_t){0.0f, 0.0f, 0.0f, 0.0f};
    }
    epf_lsb_t lsb = variant_default_lsb(variant, params);
    if (spacing > 0.0) {
        lsb.x = fminf(lsb.x, (float)(spacing / 16.0));
    }
    lsb.v = variant == &variant_q15 ? 3e-7f : 1e-9f; /* in 16 bits it goes up to 10 mm/s */
    return lsb;
}

void runner_start(runner_t *runner, model_t model, double spacing)
{
    const description_t *description = &descriptions[model];
    *runner = (runner_t){.model = model};
    if (description->variant == NULL) {
        return;
    }
    const epf_params_t params = params_of(&friction_table_2, description->update);
    const epf_lsb_t lsb = weights(description->variant, &params, spacing);
    estimator_begin(&runner->estimator, description->variant, &params, &lsb);
}

void runner_update(runner_t *runner, const update_t *update, const slide_state_t *motion,
                   double time)
{
    const description_t *description = &descriptions[runner->model];
    const double v = runner->model == MODEL_END_VELOCITY ? motion->v : update->v;
    if (description->variant != NULL && runner->estimator.variant == NULL) {
        runner->z = (double)NAN; /* it did not start */
    } else if (description->variant != NULL) {
        const motion_t step = {update->dx, v, update->dt, motion->x, time};
        estimator_step(&runner->estimator, &step);
        runner->z = estimator_estimate(&runner->estimator).z_m;
    } else {
        runner->z = description->rule(&friction_table_2, runner->z, update->dx, v, update->dt);
    }
    errors_add(&runner->errors, runner->z - motion->z);
}
