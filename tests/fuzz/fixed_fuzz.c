/* SPDX-License-Identifier: MIT */
/* libFuzzer drives parameters, weights and inputs of q31 and q15, bit by bit: no accepted set and no
   input may take the state out of its bounds or against the motion. */
#include "epf/epf.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void require(int condition)
{
    if (!condition) {
        abort();
    }
}

/* Moderate magnitudes from any bytes: most sets are then accepted */
static float weight(const uint8_t *data, float scale)
{
    return scale * (1.0f + (float)data[0]) * (data[1] % 2 ? 1e-3f : 1.0f);
}

static void check(const epf_fixed_t *ep, int32_t z_before, int32_t dx)
{
    const int32_t z_max = ep->coeffs->z_max;
    require(ep->z <= z_max && ep->z >= -z_max);
    if (dx == 0) {
        require(ep->z == z_before);
    }
    if (dx > 0 && z_before < ep->points[ep->published].z_ss) {
        require(ep->z > z_before);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size < 24) {
        return 0;
    }
    const epf_params_t params = {weight(data, 1e3f),
                                 weight(data + 2, 1.0f),
                                 weight(data + 4, 1.0f),
                                 weight(data + 6, 1.0f),
                                 weight(data + 6, 1.0f) + weight(data + 8, 0.1f),
                                 weight(data + 10, 1e-3f),
                                 weight(data + 12, 1e-6f),
                                 (epf_stribeck_t)(data[14] % 3),
                                 EPF_UPDATE_SATURATED};
    const epf_lsb_t lsb = {weight(data + 15, 1e-8f), weight(data + 17, 1e-6f),
                           weight(data + 19, 1e-3f), weight(data + 21, 1e-6f)};
    epf_q31_coeffs_t c31;
    epf_q15_coeffs_t c15;
    const int has_31 = epf_q31_coeffs_init(&c31, &params, &lsb) == EPF_OK;
    const int has_15 = epf_q15_coeffs_init(&c15, &params, &lsb) == EPF_OK;
    epf_q31_t q31;
    epf_q15_t q15;
    if (has_31) {
        epf_q31_init(&q31, &c31);
    }
    if (has_15) {
        epf_q15_init(&q15, &c15);
    }
    for (size_t i = 24; i + 12 <= size; i += 12) {
        int32_t dx;
        int32_t v;
        uint32_t dt;
        memcpy(&dx, data + i, 4);
        memcpy(&v, data + i + 4, 4);
        memcpy(&dt, data + i + 8, 4);
        if (has_31) {
            const int32_t before = q31.z;
            require(epf_q31_step(&q31, dx, v, dt) == epf_q31_output(&q31));
            check(&q31, before, dx);
        }
        if (has_15) {
            const int32_t before = q15.z;
            const int16_t force = epf_q15_step(&q15, (int16_t)dx, (int16_t)v, (uint16_t)dt);
            require(force == epf_q15_output(&q15));
            check(&q15, before, (int16_t)dx);
        }
    }
    return 0;
}
