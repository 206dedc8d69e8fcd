/* SPDX-License-Identifier: MIT */
/* Parameters: one status per cause, the output untouched on refusal, and eq. (22). */
#include "epf/epf.h"
#include "parameter_sets.h"
#include "unity.h"

#include <math.h>
#include <string.h>

static epf_params_t params;

void setUp(void)
{
    params = parameter_sets[0].params;
}

void tearDown(void)
{
}

static void refused_as(epf_status_t status, const char *why)
{
    epf_f32_coeffs_t coeffs, before;
    memset(&coeffs, 0x5a, sizeof coeffs);
    memcpy(&before, &coeffs, sizeof before);
    TEST_ASSERT_EQUAL_INT_MESSAGE(status, epf_params_check(&params), why);
    TEST_ASSERT_EQUAL_INT_MESSAGE(status, epf_f32_coeffs_init(&coeffs, &params), why);
    TEST_ASSERT_EQUAL_MEMORY_MESSAGE(&before, &coeffs, sizeof before, why);
    setUp();
}

static void test_params_of_all_contacts_are_valid(void)
{
    for (int i = 0; i < PARAMETER_SETS; i++) {
        TEST_ASSERT_EQUAL_INT_MESSAGE(EPF_OK, epf_params_check(&parameter_sets[i].params),
                                      parameter_sets[i].name);
    }
}

static void test_params_null_pointers_are_refused(void)
{
    epf_f32_coeffs_t coeffs;
    TEST_ASSERT_EQUAL_INT(EPF_ERR_NULL, epf_params_check(NULL));
    TEST_ASSERT_EQUAL_INT(EPF_ERR_NULL, epf_f32_coeffs_init(&coeffs, NULL));
    TEST_ASSERT_EQUAL_INT(EPF_ERR_NULL, epf_f32_coeffs_init(NULL, &params));
}

static void test_params_nan_and_infinity_are_refused_in_every_field(void)
{
    static const float bad[] = {NAN, INFINITY, -INFINITY};
    float *const fields[] = {&params.sigma_0, &params.sigma_1, &params.sigma_2, &params.f_c,
                             &params.f_max,   &params.v_s,     &params.z_ba};
    for (int i = 0; i < 7 * 3; i++) {
        *fields[i / 3] = bad[i % 3];
        refused_as(EPF_ERR_NOT_FINITE, "not finite");
    }
}

static void test_params_each_condition_has_its_own_status(void)
{
    static const float not_positive[] = {0.0f, -0.0f, -1.0f, 1e-39f};
    for (int i = 0; i < 4; i++) {
        params.sigma_0 = not_positive[i];
        refused_as(EPF_ERR_SIGMA_0, "sigma_0");
        params.f_c = not_positive[i];
        refused_as(EPF_ERR_F_C, "f_c");
        params.v_s = not_positive[i];
        refused_as(EPF_ERR_V_S, "v_s");
        params.z_ba = not_positive[i];
        refused_as(EPF_ERR_Z_BA, "z_ba");
    }
    params.sigma_1 = -1e-30f;
    refused_as(EPF_ERR_SIGMA_1, "sigma_1");
    params.sigma_2 = -1e-30f;
    refused_as(EPF_ERR_SIGMA_2, "sigma_2");
    params.f_max = nextafterf(params.f_c, 0.0f);
    refused_as(EPF_ERR_F_MAX, "f_max below f_c");
    params.z_ba = params.f_c / params.sigma_0;
    refused_as(EPF_ERR_Z_BA, "z_ba = z_c");
    params.stribeck = (epf_stribeck_t)3;
    refused_as(EPF_ERR_STRIBECK, "no such form");
    params.update = (epf_update_t)2;
    refused_as(EPF_ERR_UPDATE, "no such rule");
}

static void test_params_second_order_rule_is_refused_by_this_version(void)
{
    params.update = EPF_UPDATE_SECOND_ORDER;
    refused_as(EPF_ERR_UPDATE, "second order");
}

static void test_params_derived_values_out_of_range_are_refused(void)
{
    params.f_max = FLT_MAX / 8.0f;
    refused_as(EPF_ERR_RANGE, "f_max near the end of float");
    params.sigma_0 = 1e-30f;
    params.f_max = 1e9f;
    refused_as(EPF_ERR_RANGE, "z_max overflows");
    params.sigma_0 = 1e37f;
    params.z_ba = FLT_MIN;
    params.f_c = params.f_max = 1.5f * 1e37f * FLT_MIN;
    refused_as(EPF_ERR_RANGE, "1/(z_c - z_ba) overflows");
}

static void test_params_first_cause_wins_in_the_order_of_the_fields(void)
{
    params = (epf_params_t){
        0.0f, -1.0f, -1.0f, 0.0f, -1.0f, 0.0f, 0.0f, (epf_stribeck_t)9, (epf_update_t)9};
    refused_as(EPF_ERR_SIGMA_0, "order");
}

static void test_params_every_status_has_its_own_text(void)
{
    for (int i = EPF_OK; i <= EPF_ERR_RANGE; i++) {
        const char *text = epf_status_text((epf_status_t)i);
        TEST_ASSERT_TRUE(strlen(text) > 1);
        TEST_ASSERT_TRUE(strcmp(text, "unknown status") != 0);
        for (int j = EPF_OK; j < i; j++) {
            TEST_ASSERT_TRUE(strcmp(text, epf_status_text((epf_status_t)j)) != 0);
        }
    }
    TEST_ASSERT_EQUAL_STRING("unknown status", epf_status_text((epf_status_t)99));
}

/* Table II by hand: 1e5 * 1e-3 * 1/0.5 = 200; with v: 0.4 * 0.01 * 1e-3/5e-6 = 0.8 more */
static void test_equation_22_gives_the_bound_of_table_2(void)
{
    params = parameter_sets[1].params;
    TEST_ASSERT_FLOAT_WITHIN(0.001f, 200.0f, epf_sigma_1_limit(&params, 0.0f, 1e-3f));
    TEST_ASSERT_FLOAT_WITHIN(0.001f, 200.8f, epf_sigma_1_limit(&params, 0.01f, 1e-3f));
    TEST_ASSERT_FLOAT_WITHIN(0.001f, 200.8f, epf_sigma_1_limit(&params, -0.01f, 1e-3f));
    TEST_ASSERT_FLOAT_WITHIN(0.01f, 1000.0f, epf_sigma_1_limit(&params, 0.0f, 5e-3f));
}

static void test_equation_22_sets_no_bound_without_stribeck_effect(void)
{
    params.f_max = params.f_c;
    TEST_ASSERT_TRUE(isinf(epf_sigma_1_limit(&params, 0.0f, 1e-3f)));
}

static void test_equation_22_bad_input_allows_no_sigma_1(void)
{
    static const float bad_times[] = {0.0f, -1.0f, NAN, INFINITY};
    for (int i = 0; i < 4; i++) {
        TEST_ASSERT_TRUE(epf_sigma_1_limit(&params, 0.0f, bad_times[i]) == 0.0f);
    }
    TEST_ASSERT_TRUE(epf_sigma_1_limit(NULL, 0.0f, 1e-3f) == 0.0f);
    params.sigma_2 = 1.0f;
    TEST_ASSERT_TRUE(epf_sigma_1_limit(&params, NAN, 1e-3f) ==
                     epf_sigma_1_limit(&params, 0.0f, 1e-3f));
    TEST_ASSERT_TRUE(isinf(epf_sigma_1_limit(&params, -INFINITY, 1e-3f)));
    params.sigma_2 = 0.0f;
    TEST_ASSERT_TRUE(epf_sigma_1_limit(&params, INFINITY, 1e-3f) ==
                     epf_sigma_1_limit(&params, 0.0f, 1e-3f));
    params.f_c = -1.0f;
    TEST_ASSERT_TRUE(epf_sigma_1_limit(&params, 0.0f, 1e-3f) == 0.0f);
}

static void test_equation_22_is_never_nan_for_valid_parameters(void)
{
    params = (epf_params_t){1e37f,
                            0.0f,
                            0.0f,
                            1.0f,
                            nextafterf(1.0f, 2.0f),
                            1.0f,
                            5e-38f,
                            EPF_STRIBECK_LORENTZIAN,
                            EPF_UPDATE_SATURATED};
    TEST_ASSERT_EQUAL_INT(EPF_OK, epf_params_check(&params));
    TEST_ASSERT_FALSE(isnan(epf_sigma_1_limit(&params, 0.0f, 1e-3f)));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_params_of_all_contacts_are_valid);
    RUN_TEST(test_params_null_pointers_are_refused);
    RUN_TEST(test_params_nan_and_infinity_are_refused_in_every_field);
    RUN_TEST(test_params_each_condition_has_its_own_status);
    RUN_TEST(test_params_second_order_rule_is_refused_by_this_version);
    RUN_TEST(test_params_derived_values_out_of_range_are_refused);
    RUN_TEST(test_params_first_cause_wins_in_the_order_of_the_fields);
    RUN_TEST(test_params_every_status_has_its_own_text);
    RUN_TEST(test_equation_22_gives_the_bound_of_table_2);
    RUN_TEST(test_equation_22_sets_no_bound_without_stribeck_effect);
    RUN_TEST(test_equation_22_bad_input_allows_no_sigma_1);
    RUN_TEST(test_equation_22_is_never_nan_for_valid_parameters);
    return UNITY_END() != 0;
}
