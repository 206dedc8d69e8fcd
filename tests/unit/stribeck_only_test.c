/* SPDX-License-Identifier: MIT */
/* The library built with EPF_STRIBECK_ONLY=EPF_STRIBECK_GAUSSIAN, as this file is. */
#include "epf/epf.h"
#include "unity.h"

#define CONTACT(form) 1e5f, 63.0f, 0.0f, 1.0f, 2.0f, 1e-3f, 8e-6f, form, EPF_UPDATE_SATURATED
#define SIGNALS       1e-7f, 1e-5f, 1e-4f, 1e-5f

static const epf_lsb_t lsb = {SIGNALS};
static const epf_params_t lorentzian = {CONTACT(EPF_STRIBECK_LORENTZIAN)};

/* f_ss at v_s, exp(-1) above f_c = 1 N; the other forms would have 1.5 N and 1 N */
static const float gaussian_at_v_s = 1.3678794f;

void setUp(void)
{
}

void tearDown(void)
{
}

static void test_only_one_form_the_others_are_refused(void)
{
    epf_f32_coeffs_t f32;
    epf_q31_coeffs_t q31;
    epf_q15_coeffs_t q15;
    TEST_ASSERT_EQUAL_INT(EPF_ERR_STRIBECK, epf_params_check(&lorentzian));
    TEST_ASSERT_EQUAL_INT(EPF_ERR_STRIBECK, epf_f32_coeffs_init(&f32, &lorentzian));
    TEST_ASSERT_EQUAL_INT(EPF_ERR_STRIBECK, epf_q31_coeffs_init(&q31, &lorentzian, &lsb));
    TEST_ASSERT_EQUAL_INT(EPF_ERR_STRIBECK, epf_q15_coeffs_init(&q15, &lorentzian, &lsb));
}

static void test_only_one_form_it_is_the_one(void)
{
    static const epf_f32_coeffs_t f32 = EPF_F32_COEFFS(CONTACT(EPF_STRIBECK_GAUSSIAN));
    static const epf_q31_coeffs_t q31 = EPF_Q31_COEFFS(CONTACT(EPF_STRIBECK_GAUSSIAN), SIGNALS);
    static const epf_q15_coeffs_t q15 = EPF_Q15_COEFFS(CONTACT(EPF_STRIBECK_GAUSSIAN), SIGNALS);
    TEST_ASSERT_FLOAT_WITHIN(1e-5f, gaussian_at_v_s, epf_f32_fss(&f32, 1e-3f));
    TEST_ASSERT_INT32_WITHIN(2, 13679, epf_q31_fss(&q31, 100));
    TEST_ASSERT_INT32_WITHIN(12, 13679, epf_q15_fss(&q15, 100));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_only_one_form_the_others_are_refused);
    RUN_TEST(test_only_one_form_it_is_the_one);
    return UNITY_END() != 0;
}
