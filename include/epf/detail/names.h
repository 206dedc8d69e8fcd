/* SPDX-License-Identifier: MIT */
/*
 * Names for the linker in a build for one form or one rule; nothing here is for users. Such a library would
 * use coefficients of another form or rule as if they were of its own. So there the functions that check
 * parameters, and that make or take coefficients, have both in their names, and code that was compiled
 * without the same EPF_STRIBECK_ONLY and EPF_UPDATE_ONLY does not link.
 */
#ifndef EPF_DETAIL_NAMES_H
#define EPF_DETAIL_NAMES_H

#if defined(EPF_STRIBECK_ONLY) || defined(EPF_UPDATE_ONLY)

#ifdef EPF_STRIBECK_ONLY
#define EPF_FORM_IN_NAMES_ EPF_STRIBECK_ONLY
#else
#define EPF_FORM_IN_NAMES_ any_form
#endif

#ifdef EPF_UPDATE_ONLY
#define EPF_RULE_IN_NAMES_ EPF_UPDATE_ONLY
#else
#define EPF_RULE_IN_NAMES_ any_rule
#endif

#define EPF_FOR_(name)                     EPF_EXPANDED_(name, EPF_FORM_IN_NAMES_, EPF_RULE_IN_NAMES_)
#define EPF_EXPANDED_(name, form, rule)    EPF_JOINED_NAME_(name, form, rule)
#define EPF_JOINED_NAME_(name, form, rule) name##_for_##form##_and_##rule

#define epf_params_check EPF_FOR_(epf_params_check)

#define epf_f32_coeffs_init EPF_FOR_(epf_f32_coeffs_init)
#define epf_q31_coeffs_init EPF_FOR_(epf_q31_coeffs_init)
#define epf_q15_coeffs_init EPF_FOR_(epf_q15_coeffs_init)

#define epf_f32_init  EPF_FOR_(epf_f32_init)
#define epf_f32_fss   EPF_FOR_(epf_f32_fss)
#define epf_f32_alpha EPF_FOR_(epf_f32_alpha)
#define epf_q31_init  EPF_FOR_(epf_q31_init)
#define epf_q31_fss   EPF_FOR_(epf_q31_fss)
#define epf_q31_alpha EPF_FOR_(epf_q31_alpha)
#define epf_q15_init  EPF_FOR_(epf_q15_init)
#define epf_q15_fss   EPF_FOR_(epf_q15_fss)
#define epf_q15_alpha EPF_FOR_(epf_q15_alpha)

#endif

#endif
