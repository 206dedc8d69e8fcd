// SPDX-License-Identifier: MIT
// The library from C++: constant coefficients, and a contact that sticks.
#include "epf/epf.h"

namespace
{
constexpr epf_f32_coeffs_t coeffs = EPF_F32_COEFFS(1e5f, 63.0f, 0.0f, 1.0f, 1.1f, 1e-5f, 8e-6f,
                                                   EPF_STRIBECK_LORENTZIAN, EPF_UPDATE_SATURATED);
}

int main()
{
    epf_f32_t ep;
    epf_f32_init(&ep, &coeffs);
    const float z = epf_f32_update(&ep, 4e-6f, 1e-6f);
    return z > 3.9e-6f && z < 4.1e-6f && epf_f32_force(&ep, 1.0f) > 0.39f ? 0 : 1;
}
