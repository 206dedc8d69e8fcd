/* SPDX-License-Identifier: MIT */
/* Never linked: the tool reads the sizes of these objects. */
#include <epf/epf.h>

epf_f32_t contact_f32;
epf_q31_t contact_q31;
epf_q15_t contact_q15;
epf_f32_coeffs_t coeffs_f32;
epf_q31_coeffs_t coeffs_q31;
epf_q15_coeffs_t coeffs_q15;
