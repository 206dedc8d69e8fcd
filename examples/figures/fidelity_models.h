/* SPDX-License-Identifier: MIT */
/*
 * What is compared with the continuous model in the fidelity benchmark: the library in its variants, what
 * a user would take otherwise, and the exact flow: the exact solution at the mean velocity.
 */
#ifndef FIDELITY_MODELS_H
#define FIDELITY_MODELS_H

#include "errors.h"
#include "slide.h"
#include "trigger.h"
#include "variant.h"

/* In the order of the tables */
typedef enum {
    MODEL_MEAN_VALUE_F32,
    MODEL_MEAN_VALUE_Q31,
    MODEL_MEAN_VALUE_Q15,
    MODEL_SATURATED_F32,
    MODEL_SATURATED_Q31,
    MODEL_SATURATED_Q15,
    MODEL_EXACT_FLOW,
    MODEL_END_VELOCITY, /* mean value f32, told the velocity at the end of a step, not its mean */
    MODEL_AS_PRINTED,
    MODEL_EP_EULER,
    MODEL_LUGRE_EULER,
    MODEL_LUGRE_EXACT,
    MODELS
} model_t;

const char *model_name(model_t model);

/* Under which names its step stands in the benchmark; NULL: it does not */
typedef struct {
    const char *variant, *rule;
} measured_t;

measured_t model_measured(model_t model);

/* One of them at work, on the friction of Table II. Must stay where it is once started. */
typedef struct {
    model_t model;
    estimator_t estimator; /* of the library */
    double z;              /* m */
    errors_t errors;       /* of z at the updates, m */
} runner_t;

/* From rest at x = 0. Integers have at least 16 counts per spacing, m; 0: updates are timed. */
void runner_start(runner_t *runner, model_t model, double spacing);

/* Makes an update, and compares z with that of the motion, which is there at that time */
void runner_update(runner_t *runner, const update_t *update, const slide_state_t *motion,
                   double time);

#endif
