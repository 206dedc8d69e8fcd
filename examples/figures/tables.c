/* SPDX-License-Identifier: MIT */
#include "tables.h"

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
