/* SPDX-License-Identifier: MIT */
#include "parameter_sets.h"

#define LORENTZIAN EPF_STRIBECK_LORENTZIAN
#define GAUSSIAN   EPF_STRIBECK_GAUSSIAN
#define COULOMB    EPF_STRIBECK_COULOMB
#define SATURATED  EPF_UPDATE_SATURATED

/* sigma_0, sigma_1, sigma_2, f_c, f_max, v_s, z_ba */
const parameter_set_t parameter_sets[PARAMETER_SETS] = {
    {"Table I", {1e5f, 63.0f, 0.0f, 1.0f, 1.1f, 1e-5f, 0.8e-5f, LORENTZIAN, SATURATED}},
    {"Table II", {1e5f, 1e3f, 0.4f, 1.0f, 1.5f, 1e-3f, 8e-6f, LORENTZIAN, SATURATED}},
    {"Table II, Gaussian", {1e5f, 1e3f, 0.4f, 1.0f, 1.5f, 1e-3f, 8e-6f, GAUSSIAN, SATURATED}},
    {"rotary joint", {2.3e3f, 1.7f, 0.06f, 0.35f, 0.52f, 0.02f, 9e-5f, LORENTZIAN, SATURATED}},
    {"pure Coulomb", {4.124e4f, 0.0f, 0.0f, 2.358f, 2.358f, 1e-3f, 4.17e-5f, COULOMB, SATURATED}},
    {"Coulomb, f_max > f_c", {8e4f, 40.0f, 0.2f, 0.8f, 1.0f, 1e-3f, 6e-6f, COULOMB, SATURATED}},
    {"z_ba close to 0", {1e6f, 10.0f, 0.0f, 3.0f, 4.0f, 1e-2f, 3e-12f, GAUSSIAN, SATURATED}},
    {"z_ba close to z_c", {1e5f, 63.0f, 5.0f, 1.0f, 1.2f, 1e-4f, 9.99e-6f, LORENTZIAN, SATURATED}},
    {"f_max = 10 f_c", {5e4f, 20.0f, 0.1f, 0.2f, 2.0f, 5e-3f, 2e-6f, LORENTZIAN, SATURATED}},
};

epf_params_t parameters_by(epf_update_t rule, const parameter_set_t *set)
{
    epf_params_t params = set->params;
    params.update = rule;
    return params;
}
