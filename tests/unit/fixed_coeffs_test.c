/* SPDX-License-Identifier: MIT */
/* Coefficients of the fixed-point variants: what is refused, to the last float, and the units. */
#include "fixed_variant.h"
#include "parameter_sets.h"
#include "unity.h"

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <string.h>

static epf_params_t params;
static epf_lsb_t lsb;

/* Table II */
void setUp(void)
{
    params = parameter_sets[1].params;
    lsb = (epf_lsb_t){1e-8f, 1e-6f, 1e-4f, 1e-6f};
}

void tearDown(void)
{
}

static void refused_as(epf_status_t status, const char *why)
{
    for (int i = 0; i < FIXED_VARIANTS; i++) {
        any_coeffs_t coeffs, before;
        memset(&coeffs, 0x5a, sizeof coeffs);
        memcpy(&before, &coeffs, sizeof before);
        TEST_ASSERT_EQUAL_INT_MESSAGE(status,
                                      fixed_variants[i]->coeffs_init(&coeffs, &params, &lsb), why);
        TEST_ASSERT_EQUAL_MEMORY_MESSAGE(&before, &coeffs, sizeof before, why);
    }
}

static void accepted(const char *why)
{
    for (int i = 0; i < FIXED_VARIANTS; i++) {
        any_coeffs_t coeffs;
        TEST_ASSERT_EQUAL_INT_MESSAGE(EPF_OK,
                                      fixed_variants[i]->coeffs_init(&coeffs, &params, &lsb), why);
    }
}

/* The last number that is accepted, and the first beyond it, in the direction of `beyond` */
static void accepts_up_to(float *x, float last, float beyond, epf_status_t status, const char *why)
{
    *x = last;
    accepted(why);
    *x = nextafterf(last, beyond);
    refused_as(status, why);
    *x = last;
}

static void accepts_below(float *x, float first_refused, epf_status_t status, const char *why)
{
    accepts_up_to(x, nextafterf(first_refused, 0.0f), INFINITY, status, why);
}

/* ---- refusals ------------------------------------------------------------------------------- */

static void test_coeffs_null_pointers_are_refused(void)
{
    any_coeffs_t c;
    for (int i = 0; i < FIXED_VARIANTS; i++) {
        TEST_ASSERT_EQUAL_INT(EPF_ERR_NULL, fixed_variants[i]->coeffs_init(NULL, &params, &lsb));
        TEST_ASSERT_EQUAL_INT(EPF_ERR_NULL, fixed_variants[i]->coeffs_init(&c, NULL, &lsb));
        TEST_ASSERT_EQUAL_INT(EPF_ERR_NULL, fixed_variants[i]->coeffs_init(&c, &params, NULL));
    }
}

static void test_coeffs_bad_parameters_are_refused_as_in_f32(void)
{
    params.f_max = 0.5f;
    refused_as(EPF_ERR_F_MAX, "f_max");
}

static void test_coeffs_both_update_rules_are_accepted_and_nothing_else(void)
{
    static const int rules[] = {2, 3, 127, -1};
    for (int i = 0; i < UPDATE_RULES; i++) {
        params.update = (epf_update_t)i;
        accepted("update rule");
    }
    for (int i = 0; i < 4; i++) {
        params.update = (epf_update_t)rules[i];
        refused_as(EPF_ERR_UPDATE, "no update rule");
    }
}

static void test_coeffs_unusable_weights_are_refused_each_as_its_own(void)
{
    static const float bad[] = {0.0f, -1e-6f, NAN, INFINITY};
    static const struct {
        size_t offset;
        epf_status_t status;
    } weights[] = {{offsetof(epf_lsb_t, x), EPF_ERR_LSB_X},
                   {offsetof(epf_lsb_t, v), EPF_ERR_LSB_V},
                   {offsetof(epf_lsb_t, f), EPF_ERR_LSB_F},
                   {offsetof(epf_lsb_t, t), EPF_ERR_LSB_T}};
    for (int i = 0; i < 4 * 4; i++) {
        setUp();
        memcpy((char *)&lsb + weights[i / 4].offset, &bad[i % 4], sizeof(float));
        refused_as(weights[i / 4].status, "weight");
    }
}

/* ---- every boundary of what is accepted, to the last float -----------------------------------
 * Powers of two throughout, so that the quotients are exact.
 */

static void use_powers_of_two(void)
{
    params = (epf_params_t){
        1.0f, 0.0f, 0.0f, 8.0f, 16.0f, 1.0f, 1.0f, EPF_STRIBECK_LORENTZIAN, EPF_UPDATE_SATURATED};
    lsb = (epf_lsb_t){1.0f, 1.0f, 1.0f, 1.0f};
}

/* Everything as small as a normal float */
static void use_smallest(void)
{
    use_powers_of_two();
    params.f_c *= FLT_MIN;
    params.f_max *= FLT_MIN;
    params.v_s *= FLT_MIN;
    params.z_ba *= FLT_MIN;
    lsb = (epf_lsb_t){FLT_MIN, FLT_MIN, FLT_MIN, FLT_MIN};
}

static void test_boundary_weights_are_normal_floats(void)
{
    use_smallest();
    accepts_up_to(&lsb.x, FLT_MIN, 0.0f, EPF_ERR_LSB_X, "lsb.x");
    accepts_up_to(&lsb.v, FLT_MIN, 0.0f, EPF_ERR_LSB_V, "lsb.v");
    accepts_up_to(&lsb.f, FLT_MIN, 0.0f, EPF_ERR_LSB_F, "lsb.f");
    accepts_up_to(&lsb.t, FLT_MIN, 0.0f, EPF_ERR_LSB_T, "lsb.t");
}

static void test_boundary_z_ba_is_at_least_one_count(void)
{
    use_powers_of_two();
    accepts_up_to(&lsb.x, 1.0f, INFINITY, EPF_ERR_LSB_X, "z_ba of one count");
    use_powers_of_two();
    accepts_up_to(&params.z_ba, 1.0f, 0.0f, EPF_ERR_LSB_X, "z_ba of one count");
}

static void test_boundary_z_max_is_at_most_2_30_counts(void)
{
    use_powers_of_two();
    lsb.f = 65536.0f;
    accepts_up_to(&params.f_max, 1073741824.0f, INFINITY, EPF_ERR_LSB_X, "z_max");
}

/* z_shift is 0, z_c five units and a half */
static void test_boundary_z_ba_and_z_c_differ_in_units(void)
{
    use_powers_of_two();
    lsb.f = 65536.0f;
    params.f_max = 805306368.0f;
    params.f_c = 5.5f;
    accepts_below(&params.z_ba, 5.0f, EPF_ERR_LSB_X, "z_ba of five units, and z_c");
    params.f_c = 6.0f;
    params.z_ba = nextafterf(6.0f, 0.0f);
    accepted("z_c of six units");
}

static void test_boundary_v_s_is_from_2_minus_24_to_2_33_weights(void)
{
    use_powers_of_two();
    accepts_up_to(&lsb.v, 1.0f / 8589934592.0f, 0.0f, EPF_ERR_LSB_V, "2^33");
    accepts_below(&lsb.v, 16777216.0f, EPF_ERR_LSB_V, "2^-24");
}

static void test_boundary_viscous_force_of_a_count_is_below_2_24_elastic_ones(void)
{
    use_powers_of_two();
    accepts_below(&params.sigma_2, 16777216.0f, EPF_ERR_LSB_V, "sigma_2");
}

static void test_boundary_f_max_is_at_least_one_weight(void)
{
    use_powers_of_two();
    accepts_up_to(&lsb.f, 16.0f, INFINITY, EPF_ERR_LSB_F, "f_max of one lsb.f");
}

/* To the largest number of either type, in floats */
static void test_boundary_f_max_fits_the_type_of_the_force(void)
{
    static const float largest[] = {2147483520.0f, 32767.0f};
    for (int i = 0; i < FIXED_VARIANTS; i++) {
        any_coeffs_t c;
        use_powers_of_two();
        lsb.x = 1.0f;
        lsb.f = 1.0f / 65536.0f;
        params.f_max = largest[i] / 65536.0f;
        params.f_c = params.f_max / 2.0f;
        params.z_ba = params.f_c / 2.0f;
        lsb.x = params.z_ba / 2.0f;
        TEST_ASSERT_EQUAL_INT(EPF_OK, fixed_variants[i]->coeffs_init(&c, &params, &lsb));
        params.f_max = nextafterf(params.f_max, INFINITY);
        TEST_ASSERT_EQUAL_INT(EPF_ERR_LSB_F, fixed_variants[i]->coeffs_init(&c, &params, &lsb));
    }
}

static void test_boundary_damping_of_a_tick_is_below_2_24(void)
{
    use_powers_of_two();
    accepts_below(&params.sigma_1, 16777216.0f, EPF_ERR_LSB_T, "sigma_1");
}

/* ---- units ----------------------------------------------------------------------------------- */

static void check_units(const fixed_variant_t *variant)
{
    any_coeffs_t coeffs;
    TEST_ASSERT_EQUAL_INT(EPF_OK, variant->coeffs_init(&coeffs, &params, &lsb));
    const fixed_lengths_t c = variant->lengths(&coeffs);
    const double z_max = (double)(params.f_max / params.sigma_0);
    const double unit = (double)lsb.x / (double)c.unit;
    TEST_ASSERT_TRUE(c.z_max < 1L << 30 && c.z_max >= (1L << 29) - 64);
    TEST_ASSERT_TRUE(fabs(c.z_max * unit / z_max - 1.0) < 3e-7);
    TEST_ASSERT_TRUE(fabs(c.z_ba * unit / (double)params.z_ba - 1.0) < 3e-7);
    TEST_ASSERT_EQUAL_UINT32(1uL << c.z_shift, c.unit);
    TEST_ASSERT_TRUE(c.z_ba >= (int32_t)c.unit);
    const int64_t leap = (int64_t)c.leap * c.unit; /* just 2 z_max, where it fits */
    TEST_ASSERT_TRUE(leap >= 2 * (int64_t)c.z_max || c.leap == 65535u);
    TEST_ASSERT_TRUE(leap - c.unit < 2 * (int64_t)c.z_max);
    TEST_ASSERT_TRUE(variant == &q15_variant || c.leap != 65535u);
}

static void test_coeffs_z_shift_is_the_largest_that_keeps_z_max_within_2_30(void)
{
    for (int i = 0; i < 62; i++) {
        lsb.x = params.f_max / params.sigma_0 / (1.5f * powf(1.37f, (float)i)); /* to 3e8 counts */
        for (int j = 0; params.z_ba >= lsb.x && j < FIXED_VARIANTS; j++) {
            check_units(fixed_variants[j]);
        }
    }
}

/* A power of two would be 2^30 units exactly, and the difference of two states 2^31 */
static void test_coeffs_z_max_stays_below_2_30_units(void)
{
    params = (epf_params_t){65536.0f,
                            0.0f,
                            0.0f,
                            1.0f,
                            2.0f,
                            1e-3f,
                            1e-5f,
                            EPF_STRIBECK_LORENTZIAN,
                            EPF_UPDATE_SATURATED};
    lsb.x = 1.0f / 4194304.0f; /* z_max is 128 counts */
    for (int i = 0; i < FIXED_VARIANTS; i++) {
        const fixed_variant_t *variant = fixed_variants[i];
        any_coeffs_t coeffs;
        any_contact_t ep;
        TEST_ASSERT_EQUAL_INT(EPF_OK, variant->coeffs_init(&coeffs, &params, &lsb));
        const int32_t z_max = variant->lengths(&coeffs).z_max;
        TEST_ASSERT_EQUAL_INT32((1L << 30) - 1, z_max);
        variant->init(&ep, &coeffs);
        TEST_ASSERT_EQUAL_INT32(z_max, variant->update(&ep, 1000, 0));
        TEST_ASSERT_EQUAL_INT32(-z_max, variant->update(&ep, -1000, 0));
    }
}

/* What design.md section 9 allows an estimator, on cores with pointers of 32 bits or less */
static void test_footprint_of_a_contact_and_of_its_coefficients(void)
{
    const size_t pointer = sizeof(void *) > 4 ? sizeof(void *) : 4;
    TEST_ASSERT_TRUE(sizeof(epf_q31_t) <= 60 + 2 * (pointer - 4));
    TEST_ASSERT_TRUE(sizeof(epf_q15_t) <= 52 + 2 * (pointer - 4));
    TEST_ASSERT_TRUE(sizeof(epf_q15_coeffs_t) <= 48);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_coeffs_null_pointers_are_refused);
    RUN_TEST(test_coeffs_bad_parameters_are_refused_as_in_f32);
    RUN_TEST(test_coeffs_both_update_rules_are_accepted_and_nothing_else);
    RUN_TEST(test_coeffs_unusable_weights_are_refused_each_as_its_own);
    RUN_TEST(test_boundary_weights_are_normal_floats);
    RUN_TEST(test_boundary_z_ba_is_at_least_one_count);
    RUN_TEST(test_boundary_z_max_is_at_most_2_30_counts);
    RUN_TEST(test_boundary_z_ba_and_z_c_differ_in_units);
    RUN_TEST(test_boundary_v_s_is_from_2_minus_24_to_2_33_weights);
    RUN_TEST(test_boundary_viscous_force_of_a_count_is_below_2_24_elastic_ones);
    RUN_TEST(test_boundary_f_max_is_at_least_one_weight);
    RUN_TEST(test_boundary_f_max_fits_the_type_of_the_force);
    RUN_TEST(test_boundary_damping_of_a_tick_is_below_2_24);
    RUN_TEST(test_coeffs_z_shift_is_the_largest_that_keeps_z_max_within_2_30);
    RUN_TEST(test_coeffs_z_max_stays_below_2_30_units);
    RUN_TEST(test_footprint_of_a_contact_and_of_its_coefficients);
    return UNITY_END() != 0;
}
