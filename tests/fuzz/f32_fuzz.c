/* SPDX-License-Identifier: MIT */
/* libFuzzer drives parameters and inputs, bit by bit: no accepted parameter set and no input may
   take the estimator out of its bounds. */
#include "epf/epf.h"

#include <math.h>
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

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    float values[7];
    epf_f32_coeffs_t coeffs;
    epf_f32_t ep;
    if (size < sizeof values + 1) {
        return 0;
    }
    memcpy(values, data, sizeof values);
    const epf_params_t params = {
        values[0],           values[1], values[2], values[3],
        values[4],           values[5], values[6], (epf_stribeck_t)(data[sizeof values] % 4),
        EPF_UPDATE_SATURATED};
    if (epf_f32_coeffs_init(&coeffs, &params) != EPF_OK) {
        return 0;
    }
    epf_f32_init(&ep, &coeffs);
    for (size_t i = sizeof values + 1; i + 12 <= size; i += 12) {
        float sample[3];
        memcpy(sample, data + i, sizeof sample);
        const float z_before = epf_f32_z(&ep);
        const float force = epf_f32_step(&ep, sample[0], sample[1], sample[2]);
        const float z = epf_f32_z(&ep);
        require(isfinite(force) && fabsf(z) <= coeffs.z_max);
        require(!(sample[0] != sample[0] || sample[0] == 0.0f) || z == z_before);
        require(epf_f32_output(&ep) == force);
    }
    return 0;
}
