/* SPDX-License-Identifier: MIT */
#include "epf/params.h"

#include "epf/detail/constants.h"

#include "ieee.h"

#include <math.h>
#include <stddef.h>
#include <stdint.h>

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

/* ---- eq. (22), whose factors together may leave the range of float by far -------------------- */

/* mantissa 2^exponent. The mantissa of a float is an integer below 2^24, so the products and the
   quotient below stay within float, and only their exponents become large. */
typedef struct {
    float mantissa;
    int exponent;
} scaled_t;

/* Exactly x, for x >= 0 */
static scaled_t scaled(float x)
{
    const union {
        float value;
        uint32_t bits;
    } word = {x};
    const int biased = (int)(word.bits >> 23);
    const uint32_t fraction = word.bits & 0x7fffffu;
    if (biased == 0) { /* subnormal, or 0 */
        return (scaled_t){(float)fraction, -149};
    }
    return (scaled_t){(float)(fraction | 0x800000u), biased - 150};
}

/* 2^n. Beyond the range of normal floats, the last of them. */
static float power_of_2(int n)
{
    const int within = n < -126 ? -126 : n > 127 ? 127 : n;
    const union {
        uint32_t bits;
        float value;
    } word = {(uint32_t)(within + 127) << 23};
    return word.value;
}

static scaled_t product(scaled_t a, scaled_t b)
{
    return (scaled_t){a.mantissa * b.mantissa, a.exponent + b.exponent};
}

static scaled_t quotient(scaled_t a, scaled_t b)
{
    return (scaled_t){a.mantissa / b.mantissa, a.exponent - b.exponent};
}

/* a + sign b. Where the exponents differ by more than 126, the lower term is lost in the rounding of
   the other: a mantissa that is 0 never has an exponent so far above. */
static scaled_t sum(scaled_t a, float sign, scaled_t b)
{
    const int exponent = a.exponent > b.exponent ? a.exponent : b.exponent;
    const float aligned_a = a.mantissa * power_of_2(a.exponent - exponent);
    const float aligned_b = b.mantissa * power_of_2(b.exponent - exponent);
    return (scaled_t){aligned_a + sign * aligned_b, exponent};
}

/* In two steps, since 2^exponent alone may be out of range; below FLT_MIN 0, above FLT_MAX infinity */
static float to_float(scaled_t x)
{
    const int half = x.exponent / 2;
    const float value = x.mantissa * power_of_2(half) * power_of_2(x.exponent - half);
    return value < FLT_MIN ? 0.0f : value;
}

/* Seven roundings lead to the bound, each wrong by FLT_EPSILON/2 at most: this makes up for them */
#define NEVER_TOO_HIGH (1.0f - 4.0f * FLT_EPSILON)

float epf_sigma_1_limit(const epf_params_t *params, float v, float dt)
{
    if (epf_params_check(params) != EPF_OK || !(dt > 0.0f && dt <= FLT_MAX)) {
        return 0.0f;
    }
    const epf_params_t p = *params;
    const float speed = v > 0.0f ? v : v < 0.0f ? -v : 0.0f; /* NaN: 0 */
    if (p.f_max == p.f_c || (p.sigma_2 > 0.0f && speed > FLT_MAX)) {
        return INFINITY;
    }
    /* (22) with z = f/sigma_0: sigma_0 dt (f_c + sigma_2 |v|)/(f_max - f_c) */
    const scaled_t sliding = sum(scaled(p.f_c), 1.0f, product(scaled(p.sigma_2), scaled(speed)));
    const scaled_t excess = sum(scaled(p.f_max), -1.0f, scaled(p.f_c));
    const scaled_t stiffness_time = product(scaled(p.sigma_0), scaled(dt));
    scaled_t bound = quotient(product(stiffness_time, sliding), excess);
    bound.mantissa *= NEVER_TOO_HIGH;
    return to_float(bound);
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
        return "update must be a rule that this build has";
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
