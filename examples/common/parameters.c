/* SPDX-License-Identifier: MIT */
#include "parameters.h"

#include "problem.h"
#include "text.h"

#include <float.h>
#include <stdio.h>
#include <string.h>

enum {
    SIGMA_0,
    SIGMA_1,
    SIGMA_2,
    F_C,
    F_MAX,
    V_S,
    Z_BA,
    LSB_X,
    LSB_V,
    LSB_F,
    LSB_T,
    STRIBECK,
    PARAMETERS
};
static const unsigned lsb_bits = 1u << LSB_X | 1u << LSB_V | 1u << LSB_F | 1u << LSB_T;

static const char *const names[PARAMETERS] = {"sigma_0", "sigma_1", "sigma_2", "f_c",
                                              "f_max",   "v_s",     "z_ba",    "lsb_x",
                                              "lsb_v",   "lsb_f",   "lsb_t",   "stribeck"};

static const char *const stribeck_names[] = {
    [EPF_STRIBECK_LORENTZIAN] = "lorentzian",
    [EPF_STRIBECK_GAUSSIAN] = "gaussian",
    [EPF_STRIBECK_COULOMB] = "coulomb",
};
enum { STRIBECK_FORMS = sizeof stribeck_names / sizeof stribeck_names[0] };

/* The place of `text` among `count` names; `count` if it is none of them */
static int find(const char *text, const char *const *among, int count)
{
    int i = 0;
    while (i < count && strcmp(text, among[i]) != 0) {
        i++;
    }
    return i;
}

/* Where a number lives; not for STRIBECK, which is none */
static float *number(parameters_t *set, int parameter)
{
    epf_params_t *const params = &set->values;
    epf_lsb_t *const lsb = &set->lsb;
    float *const numbers[] = {&params->sigma_0, &params->sigma_1, &params->sigma_2, &params->f_c,
                              &params->f_max,   &params->v_s,     &params->z_ba,    &lsb->x,
                              &lsb->v,          &lsb->f,          &lsb->t};
    return numbers[parameter];
}

static bool is_given(const parameters_t *set, int parameter)
{
    return (set->given >> parameter & 1u) != 0;
}

bool parameters_known(const char *name)
{
    return find(name, names, PARAMETERS) < PARAMETERS;
}

static bool set_stribeck(parameters_t *set, const char *place, const char *value)
{
    const int form = find(value, stribeck_names, STRIBECK_FORMS);
    if (form == STRIBECK_FORMS) {
        problem("%s: stribeck: expected lorentzian, gaussian or coulomb, " FOUND, place, value);
        return false;
    }
    set->values.stribeck = (epf_stribeck_t)form;
    return true;
}

static bool set_number(parameters_t *set, const char *place, int parameter, const char *value)
{
    double parsed;
    if (!text_number(value, &parsed) || parsed > (double)FLT_MAX || parsed < (double)-FLT_MAX) {
        problem("%s: %s: expected a finite number, " FOUND, place, names[parameter], value);
        return false;
    }
    *number(set, parameter) = (float)parsed;
    return true;
}

bool parameters_set(parameters_t *set, const char *place, const char *name, const char *value)
{
    const int parameter = find(name, names, PARAMETERS);
    if (parameter == PARAMETERS) {
        problem("%s: expected a parameter (sigma_0, sigma_1, sigma_2, f_c, f_max, v_s, z_ba, "
                "lsb_x, lsb_v, lsb_f, lsb_t, stribeck), " FOUND,
                place, name);
        return false;
    }
    if (is_given(set, parameter)) {
        problem("%s: %s: expected once, found again", place, name);
        return false;
    }
    set->given |= 1u << parameter;
    return parameter == STRIBECK ? set_stribeck(set, place, value)
                                 : set_number(set, place, parameter, value);
}

/* ---- file ----------------------------------------------------------------------------------- */

static bool read_line(parameters_t *from_file, text_t *text)
{
    char place[1200];
    (void)snprintf(place, sizeof place, "%.1000s:%lu", text->name, text->number);

    text->line[strcspn(text->line, "#")] = '\0';
    char *const line = text_trim(text->line);
    if (*line == '\0') {
        return true;
    }
    char *const equals = strchr(line, '=');
    if (equals == NULL) {
        problem("%s: expected name = value, " FOUND, place, line);
        return false;
    }
    *equals = '\0';
    return parameters_set(from_file, place, text_trim(line), text_trim(equals + 1));
}

static void add_missing(parameters_t *set, parameters_t *more)
{
    for (int i = 0; i < PARAMETERS; i++) {
        if (is_given(set, i) || !is_given(more, i)) {
            continue;
        }
        set->given |= 1u << i;
        if (i == STRIBECK) {
            set->values.stribeck = more->values.stribeck;
        } else {
            *number(set, i) = *number(more, i);
        }
    }
}

bool parameters_read(parameters_t *set, const char *file_name)
{
    text_t text;
    if (!text_open(&text, file_name)) {
        return false;
    }
    parameters_t from_file = {.given = 0};
    bool good = true;
    text_status_t status = TEXT_LINE;
    while (good && (status = text_next(&text)) == TEXT_LINE) {
        good = read_line(&from_file, &text);
    }
    text_close(&text);
    add_missing(set, &from_file);
    return good && status == TEXT_END;
}

/* ---- checks --------------------------------------------------------------------------------- */

static bool require(const parameters_t *set, int parameter)
{
    if (!is_given(set, parameter)) {
        problem("%s is not given: expected --%s VALUE, or a line %s = VALUE in --params FILE",
                names[parameter], names[parameter], names[parameter]);
    }
    return is_given(set, parameter);
}

bool parameters_complete(parameters_t *set)
{
    if (!require(set, SIGMA_0) || !require(set, F_C) || !require(set, Z_BA)) {
        return false;
    }
    parameters_t defaults = {
        .values = {.sigma_1 = 0.0f,
                   .sigma_2 = 0.0f,
                   .f_max = set->values.f_c,
                   .v_s = 1e-3f,
                   .stribeck = EPF_STRIBECK_LORENTZIAN},
        .given = 1u << SIGMA_1 | 1u << SIGMA_2 | 1u << F_MAX | 1u << V_S | 1u << STRIBECK,
    };
    add_missing(set, &defaults);
    return true;
}

bool parameters_have_lsb(const parameters_t *set)
{
    return (set->given & lsb_bits) != 0;
}

void parameters_complete_lsb(parameters_t *set, const epf_lsb_t *defaults)
{
    parameters_t more = {.lsb = *defaults, .given = lsb_bits};
    add_missing(set, &more);
}

void parameters_refused(const parameters_t *set, epf_status_t status)
{
    parameters_t values = *set;
    char shown[512] = "";
    static const struct {
        epf_status_t status;
        unsigned involved; /* the parameters that the refusal is about */
    } causes[] = {
        {EPF_ERR_SIGMA_0, 1u << SIGMA_0},
        {EPF_ERR_SIGMA_1, 1u << SIGMA_1},
        {EPF_ERR_SIGMA_2, 1u << SIGMA_2},
        {EPF_ERR_F_C, 1u << F_C},
        {EPF_ERR_F_MAX, 1u << F_MAX | 1u << F_C},
        {EPF_ERR_V_S, 1u << V_S},
        {EPF_ERR_Z_BA, 1u << Z_BA | 1u << F_C | 1u << SIGMA_0},
        {EPF_ERR_LSB_X, 1u << LSB_X | 1u << Z_BA},
        {EPF_ERR_LSB_V, 1u << LSB_V},
        {EPF_ERR_LSB_F, 1u << LSB_F | 1u << F_MAX},
        {EPF_ERR_LSB_T, 1u << LSB_T},
        {EPF_ERR_RANGE, 1u << SIGMA_0 | 1u << F_C | 1u << F_MAX | 1u << Z_BA},
    };
    for (size_t k = 0; k < sizeof causes / sizeof causes[0]; k++) {
        for (int i = 0; causes[k].status == status && i < STRIBECK; i++) {
            if ((causes[k].involved >> i & 1u) != 0) {
                const size_t length = strlen(shown);
                (void)snprintf(shown + length, sizeof shown - length, ", found %s = %.9g", names[i],
                               (double)*number(&values, i));
            }
        }
    }
    problem("the parameters are refused: %s%s", epf_status_text(status), shown);
}
