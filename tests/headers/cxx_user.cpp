// SPDX-License-Identifier: MIT
// The library from C++: constant coefficients, and a contact that sticks.
#include "epf/epf.h"

namespace
{
constexpr epf_f32_coeffs_t coeffs = EPF_F32_COEFFS(1e5f, 63.0f, 0.0f, 1.0f, 1.1f, 1e-5f, 8e-6f,
                                                   EPF_STRIBECK_LORENTZIAN, EPF_UPDATE_SATURATED);
constexpr epf_q31_coeffs_t coeffs_q31 =
    EPF_Q31_COEFFS(1e5f, 63.0f, 0.0f, 1.0f, 1.1f, 1e-5f, 8e-6f, EPF_STRIBECK_LORENTZIAN,
                   EPF_UPDATE_SATURATED, 1e-8f, 1e-7f, 1e-5f, 1e-3f);
} // namespace

int main()
{
    epf_f32_t ep;
    epf_f32_init(&ep, &coeffs);
    const float z = epf_f32_update(&ep, 4e-6f, 1e-6f);
    epf_q31_t ep_q31;
    epf_q31_init(&ep_q31, &coeffs_q31);
    (void)epf_q31_update(&ep_q31, 400, 10);
    const int32_t force_q31 = epf_q31_force(&ep_q31, 1000);
    return force_q31 > 39000 && force_q31 < 41000 && z > 3.9e-6f && z < 4.1e-6f &&
                   epf_f32_force(&ep, 1.0f) > 0.39f
               ? 0
               : 1;
}
