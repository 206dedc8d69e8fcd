/* SPDX-License-Identifier: MIT */
/* The library built with EPF_UPDATE_ONLY, as this file is: once for each rule. */
#include "epf/epf.h"
#include "unity.h"

#define CONTACT(rule) 1e5f, 63.0f, 0.0f, 1.0f, 2.0f, 1e-3f, 8e-6f, EPF_STRIBECK_LORENTZIAN, rule
#define SIGNALS       1e-7f, 1e-5f, 1e-4f, 1e-5f

/* The rules have the values 0 and 1 */
static const epf_update_t other_rule = (epf_update_t)(1 - (int)EPF_UPDATE_ONLY);

void setUp(void)
{
}

void tearDown(void)
{
}

static void test_only_one_rule_the_other_is_refused(void)
{
    const epf_params_t other = {CONTACT(other_rule)};
    const epf_lsb_t lsb = {SIGNALS};
    epf_f32_coeffs_t f32;
    epf_q31_coeffs_t q31;
    epf_q15_coeffs_t q15;
    TEST_ASSERT_EQUAL_INT(EPF_ERR_UPDATE, epf_params_check(&other));
    TEST_ASSERT_EQUAL_INT(EPF_ERR_UPDATE, epf_f32_coeffs_init(&f32, &other));
    TEST_ASSERT_EQUAL_INT(EPF_ERR_UPDATE, epf_q31_coeffs_init(&q31, &other, &lsb));
    TEST_ASSERT_EQUAL_INT(EPF_ERR_UPDATE, epf_q15_coeffs_init(&q15, &other, &lsb));
}

/*
 * From z_max = 20 um at rest over 1.5 um, at v_s, where z_ss is 15 um: the paper's rule ends there. The
 * mean-value rule has q = 0.1, v = 0.025, h = 1 - 0.025 (1 - 0.015625) = 0.975391, and 0.0951387 of the 5 um go.
 */
static const float by_rule_um[] = {15.0f, 19.524307f};

static void test_only_one_rule_it_is_the_one(void)
{
    static const epf_f32_coeffs_t f32 = EPF_F32_COEFFS(CONTACT(EPF_UPDATE_ONLY));
    static const epf_q31_coeffs_t q31 = EPF_Q31_COEFFS(CONTACT(EPF_UPDATE_ONLY), SIGNALS);
    static const epf_q15_coeffs_t q15 = EPF_Q15_COEFFS(CONTACT(EPF_UPDATE_ONLY), SIGNALS);
    const float expected_um = by_rule_um[EPF_UPDATE_ONLY];
    epf_f32_t in_floats;
    epf_f32_init(&in_floats, &f32);
    epf_f32_reset(&in_floats, 20e-6f);
    TEST_ASSERT_FLOAT_WITHIN(1e-5f, expected_um, 1e6f * epf_f32_update(&in_floats, 1.5e-6f, 1e-3f));

    epf_q31_t in_words;
    epf_q31_init(&in_words, &q31);
    epf_q31_reset(&in_words, q31.z_max);
    const float u_q31 = (float)q31.z_max / 20.0f; /* of 1 um */
    TEST_ASSERT_FLOAT_WITHIN(2e-4f, expected_um, (float)epf_q31_update(&in_words, 15, 100) / u_q31);

    epf_q15_t in_halves;
    epf_q15_init(&in_halves, &q15);
    epf_q15_reset(&in_halves, q15.z_max);
    const float u_q15 = (float)q15.z_max / 20.0f;
    TEST_ASSERT_FLOAT_WITHIN(2e-2f, expected_um,
                             (float)epf_q15_update(&in_halves, 15, 100) / u_q15);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_only_one_rule_the_other_is_refused);
    RUN_TEST(test_only_one_rule_it_is_the_one);
    return UNITY_END() != 0;
}
