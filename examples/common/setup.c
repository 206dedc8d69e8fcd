/* SPDX-License-Identifier: MIT */
#include "setup.h"

#include "problem.h"

#include <stdlib.h>
#include <string.h>

static const option_t options[SETUP_OPTIONS] = {
    [SETUP_VARIANT] = {"--variant", "NAME",
                       "f32, q31 or q15: floats, or integers of 32 or 16 bits (f32)"},
    [SETUP_PARAMS] = {"--params", "FILE",
                      "what follows, from a file: lines name = value, # begins a comment;\n"
                      "the command line wins"},
};

void setup_options(setup_t *setup, option_group_t groups[SETUP_GROUPS])
{
    groups[0] = (option_group_t){"The estimator:", options, setup->values, SETUP_OPTIONS};
    groups[1] =
        (option_group_t){"The friction:", parameters_options, setup->parameter_values, PARAMETERS};
}

static bool choose_variant(setup_t *setup)
{
    const char *name = setup->values[SETUP_VARIANT] != NULL ? setup->values[SETUP_VARIANT] : "f32";
    setup->variant = variant_find(name);
    return setup->variant != NULL ||
           problem("command line: --variant: expected f32, q31 or q15, " FOUND, name);
}

static bool read_parameters(setup_t *setup)
{
    bool good = true;
    for (int i = 0; good && i < PARAMETERS; i++) {
        if (setup->parameter_values[i] != NULL) {
            good = parameters_set(&setup->parameters, "command line: --",
                                  parameters_options[i].name + strlen("--"),
                                  setup->parameter_values[i]);
        }
    }
    return good;
}

/* f32 takes SI units: a weight on the command line is a mistake then. A file may have weights all the
   same, since it serves the other variants, too. */
static bool check_weights(const setup_t *setup)
{
    return setup->variant->format != NULL || !parameters_have_weights(&setup->parameters) ||
           problem("command line: --lsb_x, --lsb_v, --lsb_f, --lsb_t: expected with --variant q31 "
                   "or q15, found with %s",
                   setup->variant->name);
}

/* The weights follow from the model. There are none for a bad one, which the library is about to refuse. */
static void add_default_weights(setup_t *setup)
{
    const epf_params_t model = parameters_model(&setup->parameters);
    if (setup->variant->format != NULL && epf_params_check(&model) == EPF_OK) {
        const epf_lsb_t weights = variant_default_lsb(setup->variant, &model);
        parameters_add_weights(&setup->parameters, &weights);
    }
}

int setup_read(setup_t *setup, const char *default_file)
{
    setup->parameters = (parameters_t){.given = 0};
    setup->params_file =
        setup->values[SETUP_PARAMS] != NULL ? setup->values[SETUP_PARAMS] : default_file;
    if (!choose_variant(setup) || !read_parameters(setup) || !check_weights(setup)) {
        return EXIT_USAGE;
    }
    parameters_t from_file = {.given = 0};
    if (setup->params_file != NULL && !parameters_read(&from_file, setup->params_file)) {
        return EXIT_DATA;
    }
    parameters_add(&setup->parameters, &from_file);
    if (!parameters_complete(&setup->parameters)) {
        return EXIT_USAGE;
    }
    add_default_weights(setup);
    return EXIT_SUCCESS;
}

bool setup_start(const setup_t *setup, estimator_t *estimator)
{
    const epf_params_t model = parameters_model(&setup->parameters);
    const epf_lsb_t weights = parameters_weights(&setup->parameters);
    const epf_status_t status = estimator_start(estimator, setup->variant, &model, &weights);
    return status == EPF_OK || parameters_refused(&setup->parameters, status);
}
