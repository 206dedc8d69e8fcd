/* SPDX-License-Identifier: MIT */
/* A user's program of one file, which f32_builds.cmake compiles and links as it should be and otherwise. */
#include "epf/f32.h"

static const epf_f32_coeffs_t coeffs = EPF_F32_COEFFS(
    1e5f, 63.0f, 0.0f, 1.0f, 2.0f, 1e-3f, 8e-6f, EPF_STRIBECK_LORENTZIAN, EPF_UPDATE_SATURATED);

int main(void)
{
    epf_f32_t contact;
    epf_f32_init(&contact, &coeffs);
    const float z = epf_f32_update(&contact, 1.0f, 1e-3f); /* 1.5 N, eq. (8) at v_s */
    return z > 1.499e-5f && z < 1.501e-5f ? 0 : 1;
}
