/* SPDX-License-Identifier: MIT */
/* A fixed-point image as firmware has it: constant coefficients, no start-up computation. CI links it
   for a Cortex-M0 and looks that no floating-point and no division routine came along. */
#include <epf/q15.h>
#include <epf/q31.h>

#define SLIDE \
    1e5f, 63.0f, 0.4f, 1.0f, 1.1f, 1e-5f, 8e-6f, EPF_STRIBECK_GAUSSIAN, EPF_UPDATE_SATURATED
#define SIGNALS 1e-7f, 1e-6f, 1e-3f, 1e-5f

static const epf_q31_coeffs_t coeffs_q31 = EPF_Q31_COEFFS(SLIDE, SIGNALS);
static const epf_q15_coeffs_t coeffs_q15 = EPF_Q15_COEFFS(SLIDE, SIGNALS);

int main(void)
{
    epf_q31_t q31;
    epf_q15_t q15;
    epf_q31_init(&q31, &coeffs_q31);
    epf_q15_init(&q15, &coeffs_q15);
    for (int i = 0; i < 50; i++) {
        (void)epf_q31_step(&q31, 10, 1000, 100);
        (void)epf_q15_step(&q15, 10, 1000, 100);
    }
    return (int)(epf_q31_output(&q31) + epf_q15_output(&q15));
}
