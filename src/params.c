/* SPDX-License-Identifier: MIT */
#include "epf/params.h"

#include "epf/detail/constants.h"

#include <math.h>
#include <stddef.h>

epf_status_t epf_params_check(const epf_params_t *params)
{
    if (params == NULL) {
        return EPF_ERR_NULL;
    }
    const epf_params_t p = *params;
    if (!EPF_FINITE_(p.sigma_0) || !EPF_FINITE_(p.sigma_1) || !EPF_FINITE_(p.sigma_2) ||
        !EPF_FINITE_(p.f_c) || !EPF_FINITE_(p.f_max) || !EPF_FINITE_(p.v_s) ||
        !EPF_FINITE_(p.z_ba)) {
        return EPF_ERR_NOT_FINITE;
    }
    if (!EPF_POSITIVE_(p.sigma_0)) {
        return EPF_ERR_SIGMA_0;
    }
    if (!EPF_NOT_NEGATIVE_(p.sigma_1)) {
        return EPF_ERR_SIGMA_1;
    }
    if (!EPF_NOT_NEGATIVE_(p.sigma_2)) {
        return EPF_ERR_SIGMA_2;
    }
    if (!EPF_POSITIVE_(p.f_c)) {
        return EPF_ERR_F_C;
    }
    if (!EPF_F_MAX_OK_(p.f_c, p.f_max)) {
        return EPF_ERR_F_MAX;
    }
    if (!EPF_POSITIVE_(p.v_s)) {
        return EPF_ERR_V_S;
    }
    const float z_c = p.f_c / p.sigma_0;
    const float z_max = p.f_max / p.sigma_0;
    if (!EPF_Z_BA_OK_(p.z_ba, z_c)) {
        return EPF_ERR_Z_BA;
    }
    if (!EPF_STRIBECK_OK_(p.stribeck)) {
        return EPF_ERR_STRIBECK;
    }
    if (!EPF_UPDATE_OK_(p.update)) {
        return EPF_ERR_UPDATE;
    }
    if (!EPF_RANGE_OK_(p.f_max, z_max, z_c, p.z_ba)) {
        return EPF_ERR_RANGE;
    }
    return EPF_OK;
}

float epf_sigma_1_limit(const epf_params_t *params, float v, float dt)
{
    if (epf_params_check(params) != EPF_OK || !(dt > 0.0f && dt <= FLT_MAX)) {
        return 0.0f;
    }
    const epf_params_t p = *params;
    if (!(p.f_max > p.f_c)) {
        return INFINITY;
    }
    const float speed = v > 0.0f ? v : v < 0.0f ? -v : 0.0f; /* NaN: 0 */
    const float excess = p.f_max - p.f_c;                    /* sigma_0 (z_max - z_c) */
    const float elastic = p.sigma_0 * dt * (p.f_c / excess);
    const int has_viscous = p.sigma_2 > 0.0f && speed > 0.0f; /* 0 times infinity is not a bound */
    return has_viscous ? elastic + p.sigma_2 * speed * dt * (p.sigma_0 / excess) : elastic;
}

const char *epf_status_text(epf_status_t status)
{
    switch (status) {
    case EPF_OK:
        return "ok";
    case EPF_ERR_NULL:
        return "a pointer is null";
    case EPF_ERR_NOT_FINITE:
        return "a parameter is NaN or infinite";
    case EPF_ERR_SIGMA_0:
        return "sigma_0 must be positive";
    case EPF_ERR_SIGMA_1:
        return "sigma_1 must not be negative";
    case EPF_ERR_SIGMA_2:
        return "sigma_2 must not be negative";
    case EPF_ERR_F_C:
        return "f_c must be positive";
    case EPF_ERR_F_MAX:
        return "f_max must be at least f_c";
    case EPF_ERR_V_S:
        return "v_s must be positive";
    case EPF_ERR_Z_BA:
        return "z_ba must be positive and below z_c = f_c/sigma_0";
    case EPF_ERR_STRIBECK:
        return "stribeck must be a form that this build has";
    case EPF_ERR_UPDATE:
        return "update must be a rule that this version has";
    case EPF_ERR_LSB_X:
        return "lsb.x must be positive, no coarser than z_ba and no finer than z_max 2^-30";
    case EPF_ERR_LSB_V:
        return "lsb.v must be positive, and not far too coarse or too fine for v_s and sigma_2";
    case EPF_ERR_LSB_F:
        return "lsb.f must be positive, no coarser than f_max, and f_max must fit the integer";
    case EPF_ERR_LSB_T:
        return "lsb.t must be positive, and not far too fine for sigma_1/sigma_0";
    case EPF_ERR_RANGE:
        return "the parameters together leave the range of the number format";
    }
    return "unknown status";
}
