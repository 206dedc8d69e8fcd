/* SPDX-License-Identifier: MIT */
#include "tables.h"

const friction_t table_1 = {.sigma_0 = 1e5,
                            .sigma_1 = 63.0,
                            .sigma_2 = 0.0,
                            .f_c = 1.0,
                            .f_max = 1.1,
                            .v_s = 1e-5,
                            .z_ba = 8e-6, /* f_ba = 0.8 N */
                            .form = FRICTION_LORENTZIAN};

const friction_t table_2 = {.sigma_0 = 1e5,
                            .sigma_1 = 1e3,
                            .sigma_2 = 0.4,
                            .f_c = 1.0,
                            .f_max = 1.5,
                            .v_s = 1e-3,
                            .z_ba = 8e-6,
                            .form = FRICTION_LORENTZIAN};

static epf_stribeck_t stribeck_of(friction_form_t form)
{
    switch (form) {
    case FRICTION_COULOMB:
        return EPF_STRIBECK_COULOMB;
    case FRICTION_GAUSSIAN:
        return EPF_STRIBECK_GAUSSIAN;
    case FRICTION_LORENTZIAN:
    default:
        return EPF_STRIBECK_LORENTZIAN;
    }
}

epf_params_t params_of(const friction_t *friction, epf_update_t update)
{
    return (epf_params_t){.sigma_0 = (float)friction->sigma_0,
                          .sigma_1 = (float)friction->sigma_1,
                          .sigma_2 = (float)friction->sigma_2,
                          .f_c = (float)friction->f_c,
                          .f_max = (float)friction->f_max,
                          .v_s = (float)friction->v_s,
                          .z_ba = (float)friction->z_ba,
                          .stribeck = stribeck_of(friction->form),
                          .update = update};
}

const char *update_name(epf_update_t update)
{
    return update == EPF_UPDATE_MEAN_VALUE ? "mean value" : "saturated";
}
