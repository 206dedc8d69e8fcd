/* SPDX-License-Identifier: MIT */
/* Parameters: one status per cause, the output untouched on refusal, and eq. (22). */
#include "effort.h"
#include "epf/epf.h"
#include "integers.h"
#include "parameter_sets.h"
#include "unity.h"

#include <float.h>
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

static void accepted(const char *why)
{
    TEST_ASSERT_EQUAL_INT_MESSAGE(EPF_OK, epf_params_check(&params), why);
    setUp();
}

/* The next float, of x >= 0 */
static float above(float x)
{
    return nextafterf(x, INFINITY);
}

/* The last float before x > 0 */
static float below(float x)
{
    return nextafterf(x, 0.0f);
}

/* All of the size of FLT_MIN or of 1, so that each field may be as small as it can be */
static void use_smallest(void)
{
    params.sigma_0 = FLT_MIN;
    params.f_c = params.f_max = FLT_MIN; /* z_c = 1 */
    params.v_s = FLT_MIN;
    params.z_ba = FLT_MIN;
}

static void test_params_positive_means_flt_min_or_more(void)
{
    use_smallest();
    accepted("all of them FLT_MIN");
    use_smallest();
    params.sigma_0 = below(FLT_MIN);
    refused_as(EPF_ERR_SIGMA_0, "sigma_0");
    use_smallest();
    params.f_c = below(FLT_MIN);
    refused_as(EPF_ERR_F_C, "f_c");
    use_smallest();
    params.v_s = below(FLT_MIN);
    refused_as(EPF_ERR_V_S, "v_s");
    use_smallest();
    params.z_ba = below(FLT_MIN);
    refused_as(EPF_ERR_Z_BA, "z_ba");
}

static void test_params_not_negative_means_0_or_more(void)
{
    params.sigma_1 = -0.0f;
    params.sigma_2 = -0.0f;
    accepted("0 of either sign");
    params.sigma_1 = -above(0.0f);
    refused_as(EPF_ERR_SIGMA_1, "sigma_1");
    params.sigma_2 = -above(0.0f);
    refused_as(EPF_ERR_SIGMA_2, "sigma_2");
}

static void test_params_flt_max_is_a_number_like_others(void)
{
    params.sigma_0 = FLT_MAX;
    params.f_c = params.f_max = FLT_MAX / 16.0f; /* z_c = 1/16 */
    accepted("sigma_0");
    params.sigma_1 = params.sigma_2 = params.v_s = FLT_MAX;
    accepted("sigma_1, sigma_2, v_s");
    params.f_max = FLT_MAX;
    refused_as(EPF_ERR_RANGE, "f_max");
    params.f_c = params.f_max = FLT_MAX;
    refused_as(EPF_ERR_RANGE, "f_c");
    params.z_ba = FLT_MAX;
    refused_as(EPF_ERR_Z_BA, "z_ba");
}

static void test_params_minus_flt_max_is_negative_and_not_infinite(void)
{
    params.sigma_0 = -FLT_MAX;
    refused_as(EPF_ERR_SIGMA_0, "sigma_0");
    params.sigma_1 = -FLT_MAX;
    refused_as(EPF_ERR_SIGMA_1, "sigma_1");
    params.sigma_2 = -FLT_MAX;
    refused_as(EPF_ERR_SIGMA_2, "sigma_2");
    params.f_c = -FLT_MAX;
    refused_as(EPF_ERR_F_C, "f_c");
    params.f_max = -FLT_MAX;
    refused_as(EPF_ERR_F_MAX, "f_max");
    params.v_s = -FLT_MAX;
    refused_as(EPF_ERR_V_S, "v_s");
    params.z_ba = -FLT_MAX;
    refused_as(EPF_ERR_Z_BA, "z_ba");
}

static void test_params_f_max_may_be_f_c_and_no_less(void)
{
    params.f_max = params.f_c;
    accepted("f_max = f_c");
    params.f_max = below(params.f_c);
    refused_as(EPF_ERR_F_MAX, "one ulp less");
}

static void test_params_z_ba_may_be_one_ulp_below_z_c_and_no_more(void)
{
    const float z_c = params.f_c / params.sigma_0;
    params.z_ba = below(z_c);
    accepted("one ulp below z_c");
    params.z_ba = z_c;
    refused_as(EPF_ERR_Z_BA, "z_c");
    params.z_ba = above(z_c);
    refused_as(EPF_ERR_Z_BA, "one ulp above z_c");
}

static void test_params_forms_and_rules_are_those_of_the_enumerations(void)
{
    for (int form = EPF_STRIBECK_LORENTZIAN; form <= EPF_STRIBECK_COULOMB; form++) {
        params.stribeck = (epf_stribeck_t)form;
        accepted("a form");
    }
    params.stribeck = (epf_stribeck_t)(EPF_STRIBECK_COULOMB + 1);
    refused_as(EPF_ERR_STRIBECK, "after the last form");
    params.stribeck = (epf_stribeck_t)-1;
    refused_as(EPF_ERR_STRIBECK, "before the first form");
    for (int rule = EPF_UPDATE_SATURATED; rule <= EPF_UPDATE_MEAN_VALUE; rule++) {
        params.update = (epf_update_t)rule;
        accepted("a rule");
    }
    params.update = (epf_update_t)(EPF_UPDATE_MEAN_VALUE + 1);
    refused_as(EPF_ERR_UPDATE, "after the last rule");
    params.update = (epf_update_t)-1;
    refused_as(EPF_ERR_UPDATE, "before the first rule");
}

/* Of one stiffness the largest force decides, of another the largest deflection */
static void test_params_largest_force_and_deflection_are_16th_parts_of_flt_max(void)
{
    const float largest = FLT_MAX / 16.0f;
    params.sigma_0 = 2.0f; /* z_max is half of f_max */
    params.f_max = largest;
    accepted("f_max");
    params.sigma_0 = 2.0f;
    params.f_max = above(largest);
    refused_as(EPF_ERR_RANGE, "f_max, one ulp more");
    params.sigma_0 = 0.5f; /* z_max is twice f_max */
    params.f_max = largest / 2.0f;
    accepted("z_max");
    params.sigma_0 = 0.5f;
    params.f_max = above(largest / 2.0f);
    refused_as(EPF_ERR_RANGE, "z_max, one ulp more");
}

static void test_params_mixed_region_is_flt_min_long_or_longer(void)
{
    params.sigma_0 = 1.0f;
    params.f_c = params.f_max = 3.0f * FLT_MIN;
    params.z_ba = 2.0f * FLT_MIN;
    accepted("z_c - z_ba is FLT_MIN");
    params.sigma_0 = 1.0f;
    params.f_c = params.f_max = 3.0f * FLT_MIN;
    params.z_ba = above(2.0f * FLT_MIN);
    refused_as(EPF_ERR_RANGE, "one ulp less");
}

/* Everything is wrong; then one field after the other is mended */
static void test_params_first_cause_wins_in_the_order_of_the_fields(void)
{
    const epf_params_t good = params;
    epf_params_t bad = {-1.0f,          -1.0f, -1.0f, -1.0f, -2.0f, -1.0f, -1.0f, (epf_stribeck_t)9,
                        (epf_update_t)9};
#define MEND(field, status)               \
    params = bad;                         \
    refused_as(EPF_ERR_##status, #field); \
    bad.field = good.field
    bad.sigma_0 = NAN;
    params = bad;
    refused_as(EPF_ERR_NOT_FINITE, "NaN before all");
    bad.sigma_0 = -1.0f;
    MEND(sigma_0, SIGMA_0);
    MEND(sigma_1, SIGMA_1);
    MEND(sigma_2, SIGMA_2);
    MEND(f_c, F_C);
    MEND(f_max, F_MAX);
    bad.f_max = FLT_MAX; /* right by itself, but out of range */
    MEND(v_s, V_S);
    MEND(z_ba, Z_BA);
    MEND(stribeck, STRIBECK);
    MEND(update, UPDATE);
    MEND(f_max, RANGE);
#undef MEND
    params = bad;
    accepted("all mended");
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
    static const float bad_times[] = {0.0f, -FLT_MIN, -1.0f, NAN, INFINITY, -INFINITY};
    params = parameter_sets[1].params;
    for (int i = 0; i < 6; i++) {
        TEST_ASSERT_TRUE(epf_sigma_1_limit(&params, 0.0f, bad_times[i]) == 0.0f);
    }
    TEST_ASSERT_TRUE(epf_sigma_1_limit(NULL, 0.0f, 1e-3f) == 0.0f);
    params.f_c = -1.0f;
    TEST_ASSERT_TRUE(epf_sigma_1_limit(&params, 0.0f, 1e-3f) == 0.0f);
}

static void test_equation_22_velocity_that_is_nan_counts_as_0(void)
{
    params = parameter_sets[1].params;
    TEST_ASSERT_TRUE(params.sigma_2 > 0.0f);
    TEST_ASSERT_TRUE(epf_sigma_1_limit(&params, NAN, 1e-3f) ==
                     epf_sigma_1_limit(&params, 0.0f, 1e-3f));
}

/* With so little viscosity and so short a time, FLT_MAX would make no difference to the bound */
static void test_equation_22_infinite_velocity_has_no_bound_unless_without_viscosity(void)
{
    params = parameter_sets[1].params;
    params.sigma_2 = above(0.0f);
    TEST_ASSERT_FLOAT_WITHIN(0.001f, 200.0f, epf_sigma_1_limit(&params, FLT_MAX, 1e-3f));
    TEST_ASSERT_TRUE(isinf(epf_sigma_1_limit(&params, INFINITY, 1e-3f)));
    TEST_ASSERT_TRUE(isinf(epf_sigma_1_limit(&params, -INFINITY, 1e-3f)));
    params.sigma_2 = 0.0f;
    TEST_ASSERT_FLOAT_WITHIN(0.001f, 200.0f, epf_sigma_1_limit(&params, INFINITY, 1e-3f));
    TEST_ASSERT_FLOAT_WITHIN(0.001f, 200.0f, epf_sigma_1_limit(&params, -INFINITY, 1e-3f));
}

static void test_equation_22_velocity_0_leaves_the_first_term(void)
{
    params = parameter_sets[1].params;
    const float with_viscosity = epf_sigma_1_limit(&params, 0.0f, 1e-3f);
    TEST_ASSERT_TRUE(with_viscosity == epf_sigma_1_limit(&params, -0.0f, 1e-3f));
    params.sigma_2 = 0.0f;
    TEST_ASSERT_TRUE(with_viscosity == epf_sigma_1_limit(&params, 0.0f, 1e-3f));
}

/* The rest of the contact does not matter */
static void use(float sigma_0, float sigma_2, float f_c, float f_max)
{
    params = (epf_params_t){.sigma_0 = sigma_0,
                            .sigma_2 = sigma_2,
                            .f_c = f_c,
                            .f_max = f_max,
                            .v_s = 1.0f,
                            .z_ba = f_c / sigma_0 / 2.0f};
    TEST_ASSERT_EQUAL_INT(EPF_OK, epf_params_check(&params));
}

static void bound_is(float expected, float v, float dt)
{
    TEST_ASSERT_FLOAT_WITHIN(1e-6f * expected, expected, epf_sigma_1_limit(&params, v, dt));
}

/* Most are powers of two, so that the bound is exact by hand */
static void test_equation_22_no_intermediate_result_leaves_the_range(void)
{
    use(1e30f, 1e-30f, 1e-7f, above(1e-7f)); /* f_max - f_c is 2^-47 */
    bound_is(1.4073749e34f, 1e-25f, 1e-3f);  /* 1e30 1e-3 1e-7/2^-47 */
    bound_is(1.4073749e34f, 0.0f, 1e-3f);

    use(0x1p100f, 0.0f, 1.0f, 9.0f);
    bound_is(0x1p127f, 0.0f, 0x1p30f); /* sigma_0 dt is 2^130 */
    use(0x1p-100f, 0.0f, 0x1p20f, above(0x1p20f));
    bound_is(0x1p-123f, 0.0f, 0x1p-46f); /* sigma_0 dt is 2^-146, the rest 2^23 */

    use(0x1p-120f, 0x1p120f, 1.0f, 2.0f);
    bound_is(0x1p100f, 0x1p100f, 1.0f); /* sigma_2 v is 2^220 */
    use(1.0f, 0x1p-120f, 0x1p-125f, 0x1p-100f);
    bound_is(0x1p15f + 1.0f, 0x1p-20f, 0x1p40f); /* sigma_2 v is 2^-140, f_c 2^15 times that */
}

static void test_equation_22_subnormal_factors_count_in_full(void)
{
    const float smallest = above(0.0f); /* 2^-149 */
    use(0x1p100f, 0.0f, 1.0f, 2.0f);
    bound_is(0x1p-49f, 0.0f, smallest);
    use(1.0f, smallest, 0x1p-125f, 0x1p-124f);
    bound_is(1.0f + 0x1p-10f, 0x1p14f, 1.0f); /* sigma_2 v is 2^-135 */
    use(1.0f, 0x1p14f, 0x1p-125f, 0x1p-124f);
    bound_is(1.0f + 0x1p-10f, -smallest, 1.0f);
    use(1.0f, 0.0f, 3.0f * FLT_MIN, above(3.0f * FLT_MIN)); /* f_max - f_c is 2^-148 */
    bound_is(0x3p22f, 0.0f, 1.0f);
}

static void test_equation_22_beyond_the_normal_floats_the_bound_is_0_or_infinity(void)
{
    use(1.0f, 0.0f, 1.0f, 2.0f); /* the bound is dt */
    bound_is(1.00001f * FLT_MIN, 0.0f, 1.00001f * FLT_MIN);
    TEST_ASSERT_TRUE(epf_sigma_1_limit(&params, 0.0f, FLT_MIN) == 0.0f); /* rounded down */
    TEST_ASSERT_TRUE(epf_sigma_1_limit(&params, 0.0f, above(0.0f)) == 0.0f);
    bound_is(FLT_MAX, 0.0f, FLT_MAX);
    use(1.0f, 0.0f, 1.0f, 1.99999f); /* a little more than dt */
    bound_is(0.99999f * FLT_MAX, 0.0f, 0.99998f * FLT_MAX);
    TEST_ASSERT_TRUE(isinf(epf_sigma_1_limit(&params, 0.0f, FLT_MAX)));
    use(0x1p100f, 0.0f, 1.0f, above(1.0f));
    TEST_ASSERT_TRUE(isinf(epf_sigma_1_limit(&params, 0.0f, FLT_MAX))); /* 2^251 */
    use(0x1p-120f, 0.0f, FLT_MIN, 1.0f);
    TEST_ASSERT_TRUE(epf_sigma_1_limit(&params, 0.0f, above(0.0f)) == 0.0f); /* 2^-395 */
}

/* ---- random parameters of all exponents ----------------------------------------------------- */

static uint32_t random_state;

/* Any float of either sign of the exponent, from 0 to FLT_MAX */
static float random_magnitude(void)
{
    const union {
        uint32_t bits;
        float value;
    } word = {random_below(&random_state, 0x7f800000u)};
    return word.value;
}

static float random_or_0(void)
{
    return random_below(&random_state, 8) == 0 ? 0.0f : random_magnitude();
}

/* A quarter of them within 16 ulp of f_c */
static float random_f_max(float f_c)
{
    float f_max = random_magnitude();
    if (random_below(&random_state, 4) == 0) {
        f_max = f_c;
        for (uint32_t ulps = random_below(&random_state, 16); ulps > 0; ulps--) {
            f_max = above(f_max);
        }
    }
    return f_max;
}

static void use_random(void)
{
    do {
        const float f_c = random_magnitude();
        params = (epf_params_t){.sigma_0 = random_magnitude(),
                                .sigma_2 = random_or_0(),
                                .f_c = f_c,
                                .f_max = random_f_max(f_c),
                                .v_s = 1.0f};
        params.z_ba = params.f_c / params.sigma_0 / 2.0f;
    } while (epf_params_check(&params) != EPF_OK);
}

/* Infinite where f_max = f_c */
static double exact_bound(float v, float dt)
{
    const double force = (double)params.f_c + (double)params.sigma_2 * fabs((double)v);
    const double excess = (double)params.f_max - (double)params.f_c;
    return (double)params.sigma_0 * (double)dt * force / excess;
}

typedef enum { ZERO, FINITE, INFINITE, KINDS } kind_t;

/* What params.h promises of `bound` */
static kind_t kind_as_promised(double bound, double exact)
{
    const double least = exact * (1.0 - 1e-6);
    if (bound > (double)FLT_MAX) {
        TEST_ASSERT_TRUE_MESSAGE(exact > (double)FLT_MAX, "infinite, but need not be");
        return INFINITE;
    }
    TEST_ASSERT_TRUE_MESSAGE(bound <= exact, "too high, or NaN");
    TEST_ASSERT_TRUE_MESSAGE(bound >= least || (bound == 0.0 && least < (double)FLT_MIN),
                             "too low");
    TEST_ASSERT_TRUE_MESSAGE(bound == 0.0 || bound >= (double)FLT_MIN, "subnormal");
    return bound == 0.0 ? ZERO : FINITE;
}

static void test_equation_22_is_rounded_down_by_less_than_1e_6_whatever_the_exponents(void)
{
    if (DBL_MANT_DIG < 53 || DBL_MAX_EXP < 1024) {
        TEST_IGNORE_MESSAGE("double is float here");
    }
    unsigned seen[KINDS] = {0, 0, 0};
    random_state = 22;
    for (unsigned i = 0; i < EFFORT(200000u); i++) {
        use_random();
        const float speed = random_or_0();
        const float v = random_below(&random_state, 2) == 0 ? speed : -speed;
        const float dt = above(random_magnitude() / 2.0f);
        seen[kind_as_promised((double)epf_sigma_1_limit(&params, v, dt), exact_bound(v, dt))]++;
    }
    for (int kind = 0; kind < KINDS; kind++) {
        TEST_ASSERT_TRUE(seen[kind] > EFFORT(10000u));
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_params_of_all_contacts_are_valid);
    RUN_TEST(test_params_null_pointers_are_refused);
    RUN_TEST(test_params_nan_and_infinity_are_refused_in_every_field);
    RUN_TEST(test_params_each_condition_has_its_own_status);
    RUN_TEST(test_params_derived_values_out_of_range_are_refused);
    RUN_TEST(test_params_positive_means_flt_min_or_more);
    RUN_TEST(test_params_not_negative_means_0_or_more);
    RUN_TEST(test_params_flt_max_is_a_number_like_others);
    RUN_TEST(test_params_minus_flt_max_is_negative_and_not_infinite);
    RUN_TEST(test_params_f_max_may_be_f_c_and_no_less);
    RUN_TEST(test_params_z_ba_may_be_one_ulp_below_z_c_and_no_more);
    RUN_TEST(test_params_forms_and_rules_are_those_of_the_enumerations);
    RUN_TEST(test_params_largest_force_and_deflection_are_16th_parts_of_flt_max);
    RUN_TEST(test_params_mixed_region_is_flt_min_long_or_longer);
    RUN_TEST(test_params_first_cause_wins_in_the_order_of_the_fields);
    RUN_TEST(test_params_every_status_has_its_own_text);
    RUN_TEST(test_equation_22_gives_the_bound_of_table_2);
    RUN_TEST(test_equation_22_sets_no_bound_without_stribeck_effect);
    RUN_TEST(test_equation_22_bad_input_allows_no_sigma_1);
    RUN_TEST(test_equation_22_velocity_that_is_nan_counts_as_0);
    RUN_TEST(test_equation_22_infinite_velocity_has_no_bound_unless_without_viscosity);
    RUN_TEST(test_equation_22_velocity_0_leaves_the_first_term);
    RUN_TEST(test_equation_22_no_intermediate_result_leaves_the_range);
    RUN_TEST(test_equation_22_subnormal_factors_count_in_full);
    RUN_TEST(test_equation_22_beyond_the_normal_floats_the_bound_is_0_or_infinity);
    RUN_TEST(test_equation_22_is_rounded_down_by_less_than_1e_6_whatever_the_exponents);
    return UNITY_END() != 0;
}
