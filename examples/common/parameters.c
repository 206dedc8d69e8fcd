/* SPDX-License-Identifier: MIT */
#include "parameters.h"

#include "problem.h"
#include "text.h"

#include <float.h>
#include <stdio.h>
#include <string.h>

const option_t parameters_options[PARAMETERS] = {
    [PARAMETER_SIGMA_0] = {"--sigma_0", "VALUE", "stiffness of the contact, N/m"},
    [PARAMETER_SIGMA_1] = {"--sigma_1", "VALUE", "damping of the contact, N s/m (0)"},
    [PARAMETER_SIGMA_2] = {"--sigma_2", "VALUE", "viscous friction, N s/m (0)"},
    [PARAMETER_F_C] = {"--f_c", "VALUE", "Coulomb friction, N"},
    [PARAMETER_F_MAX] = {"--f_max", "VALUE", "largest static friction, N (f_c)"},
    [PARAMETER_V_S] = {"--v_s", "VALUE", "Stribeck velocity, m/s (1e-3)"},
    [PARAMETER_Z_BA] = {"--z_ba", "VALUE", "break-away deflection, m"},
    [PARAMETER_STRIBECK] = {"--stribeck", "FORM", "lorentzian, gaussian or coulomb (lorentzian)"},
    [PARAMETER_UPDATE] = {"--update", "RULE", "saturated or mean_value (mean_value)"},
    [PARAMETER_LSB_X] = {"--lsb_x", "VALUE",
                         "with q31 and q15, what 1 in each signal weighs:\n"
                         "displacement, m (z_max/1e6, z_max/16000)"},
    [PARAMETER_LSB_V] = {"--lsb_v", "VALUE", "velocity, m/s (v_s/1e5, v_s/100)"},
    [PARAMETER_LSB_F] = {"--lsb_f", "VALUE", "force, N (f_max/1e6, f_max/16000)"},
    [PARAMETER_LSB_T] = {"--lsb_t", "VALUE", "time, s (1e-6, 1e-5)"},
};

/* The words that a parameter may be. Where there are none, it is a number. */
static const struct {
    int words;
    const char *word[3];
    const char *expected;
} choices[PARAMETERS] = {
    [PARAMETER_STRIBECK] = {3,
                            {[EPF_STRIBECK_LORENTZIAN] = "lorentzian",
                             [EPF_STRIBECK_GAUSSIAN] = "gaussian",
                             [EPF_STRIBECK_COULOMB] = "coulomb"},
                            "lorentzian, gaussian or coulomb"},
    [PARAMETER_UPDATE] =
        {2,
         {[EPF_UPDATE_SATURATED] = "saturated", [EPF_UPDATE_MEAN_VALUE] = "mean_value"},
         "saturated or mean_value"},
};

#define BIT(parameter) (1u << (parameter))
static const unsigned weights_bits =
    BIT(PARAMETER_LSB_X) | BIT(PARAMETER_LSB_V) | BIT(PARAMETER_LSB_F) | BIT(PARAMETER_LSB_T);

static const char *name_of(int parameter)
{
    return parameters_options[parameter].name + strlen("--");
}

static bool is_given(const parameters_t *set, int parameter)
{
    return (set->given & BIT(parameter)) != 0;
}

static void give(parameters_t *set, int parameter, float value)
{
    set->value[parameter] = value;
    set->given |= BIT(parameter);
}

/* ---- by name -------------------------------------------------------------------------------- */

static int find(const char *name)
{
    int i = 0;
    while (i < PARAMETERS && strcmp(name, name_of(i)) != 0) {
        i++;
    }
    return i;
}

static bool set_choice(parameters_t *set, const char *place, int parameter, const char *value)
{
    for (int i = 0; i < choices[parameter].words; i++) {
        if (strcmp(value, choices[parameter].word[i]) == 0) {
            give(set, parameter, (float)i);
            return true;
        }
    }
    return problem("%s%s: expected %s, " FOUND, place, name_of(parameter),
                   choices[parameter].expected, value);
}

static bool set_number(parameters_t *set, const char *place, int parameter, const char *value)
{
    double parsed;
    if (!text_number(value, &parsed) || parsed > (double)FLT_MAX || parsed < (double)-FLT_MAX) {
        return problem("%s%s: expected a finite number, " FOUND, place, name_of(parameter), value);
    }
    give(set, parameter, (float)parsed);
    return true;
}

bool parameters_set(parameters_t *set, const char *place, const char *name, const char *value)
{
    const int parameter = find(name);
    if (parameter == PARAMETERS) {
        return problem("%sexpected a parameter (such as f_c, see --help), " FOUND, place, name);
    }
    if (is_given(set, parameter)) {
        return problem("%s%s: expected once, found again", place, name);
    }
    return choices[parameter].words != 0 ? set_choice(set, place, parameter, value)
                                         : set_number(set, place, parameter, value);
}

/* ---- together ------------------------------------------------------------------------------- */

void parameters_add(parameters_t *set, const parameters_t *more)
{
    for (int i = 0; i < PARAMETERS; i++) {
        if (is_given(more, i) && !is_given(set, i)) {
            give(set, i, more->value[i]);
        }
    }
}

static bool require(const parameters_t *set, int parameter)
{
    const char *name = name_of(parameter);
    return is_given(set, parameter) ||
           problem(
               "command line: --%s: expected, or a line %s = VALUE in --params FILE, found neither",
               name, name);
}

bool parameters_complete(parameters_t *set)
{
    if (!require(set, PARAMETER_SIGMA_0) || !require(set, PARAMETER_F_C) ||
        !require(set, PARAMETER_Z_BA)) {
        return false;
    }
    parameters_t defaults = {.given = 0};
    give(&defaults, PARAMETER_SIGMA_1, 0.0f);
    give(&defaults, PARAMETER_SIGMA_2, 0.0f);
    give(&defaults, PARAMETER_F_MAX, set->value[PARAMETER_F_C]);
    give(&defaults, PARAMETER_V_S, 1e-3f);
    give(&defaults, PARAMETER_STRIBECK, (float)EPF_STRIBECK_LORENTZIAN);
    give(&defaults, PARAMETER_UPDATE, (float)EPF_UPDATE_MEAN_VALUE);
    parameters_add(set, &defaults);
    return true;
}

bool parameters_have_weights(const parameters_t *set)
{
    return (set->given & weights_bits) != 0;
}

void parameters_add_weights(parameters_t *set, const epf_lsb_t *weights)
{
    parameters_t more = {.given = 0};
    give(&more, PARAMETER_LSB_X, weights->x);
    give(&more, PARAMETER_LSB_V, weights->v);
    give(&more, PARAMETER_LSB_F, weights->f);
    give(&more, PARAMETER_LSB_T, weights->t);
    parameters_add(set, &more);
}

/* ---- as the library takes them -------------------------------------------------------------- */

epf_params_t parameters_model(const parameters_t *set)
{
    const float *const value = set->value;
    return (epf_params_t){
        .sigma_0 = value[PARAMETER_SIGMA_0],
        .sigma_1 = value[PARAMETER_SIGMA_1],
        .sigma_2 = value[PARAMETER_SIGMA_2],
        .f_c = value[PARAMETER_F_C],
        .f_max = value[PARAMETER_F_MAX],
        .v_s = value[PARAMETER_V_S],
        .z_ba = value[PARAMETER_Z_BA],
        .stribeck = (epf_stribeck_t)value[PARAMETER_STRIBECK],
        .update = (epf_update_t)value[PARAMETER_UPDATE],
    };
}

epf_lsb_t parameters_weights(const parameters_t *set)
{
    const float *const value = set->value;
    return (epf_lsb_t){value[PARAMETER_LSB_X], value[PARAMETER_LSB_V], value[PARAMETER_LSB_F],
                       value[PARAMETER_LSB_T]};
}

/* The parameters that a refusal is about */
static unsigned involved(epf_status_t status)
{
    static const struct {
        epf_status_t status;
        unsigned parameters;
    } causes[] = {
        {EPF_ERR_SIGMA_0, BIT(PARAMETER_SIGMA_0)},
        {EPF_ERR_SIGMA_1, BIT(PARAMETER_SIGMA_1)},
        {EPF_ERR_SIGMA_2, BIT(PARAMETER_SIGMA_2)},
        {EPF_ERR_F_C, BIT(PARAMETER_F_C)},
        {EPF_ERR_F_MAX, BIT(PARAMETER_F_MAX) | BIT(PARAMETER_F_C)},
        {EPF_ERR_V_S, BIT(PARAMETER_V_S)},
        {EPF_ERR_Z_BA, BIT(PARAMETER_Z_BA) | BIT(PARAMETER_F_C) | BIT(PARAMETER_SIGMA_0)},
        {EPF_ERR_LSB_X, BIT(PARAMETER_LSB_X) | BIT(PARAMETER_Z_BA)},
        {EPF_ERR_LSB_V, BIT(PARAMETER_LSB_V)},
        {EPF_ERR_LSB_F, BIT(PARAMETER_LSB_F) | BIT(PARAMETER_F_MAX)},
        {EPF_ERR_LSB_T, BIT(PARAMETER_LSB_T)},
        {EPF_ERR_RANGE,
         BIT(PARAMETER_SIGMA_0) | BIT(PARAMETER_F_C) | BIT(PARAMETER_F_MAX) | BIT(PARAMETER_Z_BA)},
    };
    for (size_t k = 0; k < sizeof causes / sizeof causes[0]; k++) {
        if (causes[k].status == status) {
            return causes[k].parameters;
        }
    }
    return 0;
}

bool parameters_refused(const parameters_t *set, epf_status_t status)
{
    char shown[512] = "";
    for (int i = 0; i < PARAMETERS; i++) {
        if ((involved(status) & BIT(i)) != 0) {
            const size_t length = strlen(shown);
            (void)snprintf(shown + length, sizeof shown - length, ", found %s = %.9g", name_of(i),
                           (double)set->value[i]);
        }
    }
    return problem("the parameters are refused: %s%s", epf_status_text(status), shown);
}
