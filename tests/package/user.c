/* SPDX-License-Identifier: MIT */
/* A user's program, the same for every way of getting the library into a project. */
#include <epf/epf.h>

#include <stdio.h>

int main(void)
{
    static const epf_f32_coeffs_t slide = EPF_F32_COEFFS(
        1e5f, 63.0f, 0.0f, 1.0f, 1.1f, 1e-5f, 8e-6f, EPF_STRIBECK_LORENTZIAN, EPF_UPDATE_SATURATED);
    epf_f32_t ep;
    epf_f32_init(&ep, &slide);
    const float force = epf_f32_step(&ep, 4e-6f, 4e-6f, 1.0f);
    printf("epf %d.%d.%d: %.4f N\n", EPF_VERSION_MAJOR, EPF_VERSION_MINOR, EPF_VERSION_PATCH,
           (double)force);
    static const epf_q15_coeffs_t slide_q15 =
        EPF_Q15_COEFFS(1e5f, 63.0f, 0.0f, 1.0f, 1.1f, 1e-5f, 8e-6f, EPF_STRIBECK_LORENTZIAN,
                       EPF_UPDATE_SATURATED, 1e-7f, 1e-7f, 1e-4f, 1e-3f);
    epf_q15_t ep_q15;
    epf_q15_init(&ep_q15, &slide_q15);
    const int force_q15 = epf_q15_step(&ep_q15, 40, 40, 1000);
    return force > 0.3999f && force < 0.4005f && force_q15 >= 3999 && force_q15 <= 4005 ? 0 : 1;
}
