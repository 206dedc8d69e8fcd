/* SPDX-License-Identifier: MIT */
/* The proposition from which Theorems 1 to 4 follow for an update rule, and what else both rules promise
   of one step, to the resolution of the state. */
#include "effort.h"
#include "f32_properties.h"
#include "f32_walk.h"
#include "parameter_sets.h"
#include "sequences.h"
#include "unity.h"

#include <math.h>

void setUp(void)
{
}

void tearDown(void)
{
}

static void test_proposition_a_below_z_ss_deflection_rises_by_no_more_than_the_displacement(void)
{
    f32_walk_corners_too(5000, f32_rises_by_no_more_than_the_displacement);
}

static void test_proposition_b_motion_is_elastic_up_to_z_ba(void)
{
    f32_walk_corners_too(5000, f32_is_elastic_up_to_z_ba);
}

static void test_proposition_c_above_z_ss_deflection_goes_towards_it_and_not_beyond(void)
{
    f32_walk_corners_too(5000, f32_lets_go_from_above_z_ss);
}

static void test_proposition_d_every_displacement_closes_its_share_of_the_gap(void)
{
    f32_walk_corners_too(5000, f32_gap_closes);
}

/* ---- of contacts in every state -------------------------------------------------------------- */

/* One displacement of a contact whose start and velocity are chosen */
static f32_step_t displaced(const epf_f32_coeffs_t *coeffs, const epf_params_t *params, float start,
                            float v, float dx)
{
    f32_step_t step = {.contact = "any state",
                       .sequence = "one displacement",
                       .params = params,
                       .coeffs = coeffs,
                       .dx = dx,
                       .v = v,
                       .dt = 1e-3f};
    epf_f32_t ep;
    epf_f32_init(&ep, coeffs);
    epf_f32_reset(&ep, start);
    f32_step_take(&step, &ep);
    return step;
}

/* From z_max, where z_ss is z_c: too long a q = d/z_ss would leave the polynomial's range */
static void test_proposition_c_holds_for_displacements_of_every_exponent(void)
{
    for (int i = 0; i < PARAMETER_SETS * UPDATE_RULES; i += EFFORT_CONTACTS_ONE_IN) {
        const epf_params_t params =
            parameters_by((epf_update_t)(i % UPDATE_RULES), &parameter_sets[i / UPDATE_RULES]);
        epf_f32_coeffs_t coeffs;
        TEST_ASSERT_EQUAL_INT(EPF_OK, epf_f32_coeffs_init(&coeffs, &params));
        for (int exponent = -149; exponent < 128; exponent++) {
            for (int eighths = 8; eighths < 16; eighths++) {
                const float dx = ldexpf((float)eighths / 8.0f, exponent);
                const f32_step_t step = displaced(&coeffs, &params, coeffs.z_max, INFINITY, dx);
                f32_lets_go_from_above_z_ss(&step);
                f32_gap_closes(&step);
                f32_leap_arrives(&step);
            }
        }
    }
}

/* 2^-n, n random and no integer */
static float random_power(sequence_t *q, int least, int most)
{
    const double n = sequence_uniform(q, (double)least, (double)most);
    return ldexpf(2.0f - (float)(n - floor(n)), -(int)floor(n) - 1);
}

/* z_ba next to z_c, and f_max far above f_c: from far away z_ss - z_ba is below a rounding of z_ss - zeta */
static epf_params_t narrow_contact(sequence_t *q, epf_update_t rule)
{
    const float f_c = (float)sequence_uniform(q, 1.0, 2.0);
    const float z_ba = f_c * (1.0f - random_power(q, 10, 24));
    return (epf_params_t){1.0f,
                          0.0f,
                          0.0f,
                          f_c,
                          f_c / random_power(q, 0, 10),
                          1e-3f,
                          z_ba < f_c ? z_ba : nextafterf(f_c, 0.0f),
                          EPF_STRIBECK_LORENTZIAN,
                          rule};
}

/* From the other side of 0 to a little beyond z_ba, where z_ss is z_c */
static void test_proposition_holds_where_the_plastic_region_is_below_a_rounding_of_z(void)
{
    sequence_t q;
    sequence_start(&q, SEQUENCE_LEAPS, 8);
    for (long i = 0; i < EFFORT(200000L); i++) {
        const epf_params_t params = narrow_contact(&q, (epf_update_t)(i % UPDATE_RULES));
        epf_f32_coeffs_t coeffs;
        TEST_ASSERT_EQUAL_INT(EPF_OK, epf_f32_coeffs_init(&coeffs, &params));
        const float start = -coeffs.z_max * (float)sequence_uniform(&q, 0.0, 1.0);
        const float dx = coeffs.z_ba - start + coeffs.z_c * random_power(&q, 0, 24);
        const f32_step_t step = displaced(&coeffs, &params, start, INFINITY, dx);
        f32_rises_by_no_more_than_the_displacement(&step);
        f32_is_elastic_up_to_z_ba(&step);
        f32_leap_arrives(&step);
        f32_check(&step, fabsf(step.z) <= coeffs.z_max, "|z| <= z_max");
    }
}

/* zeta' for a longer displacement is nearer to z_ss, but for the roundings of one step */
static void ends_further_on_the_longer_it_is(const epf_f32_coeffs_t *coeffs,
                                             const epf_params_t *params, float start, float v)
{
    enum { LENGTHS = 200 };
    double gap_before = (double)INFINITY;
    for (int i = 1; i <= LENGTHS; i++) {
        const float dx = 2.0f * coeffs->z_max * (float)i / (float)LENGTHS;
        const f32_step_t step = displaced(coeffs, params, start, v, dx);
        const double gap = fabs((double)step.z_ss - (double)step.z - (double)step.after.z_low);
        f32_check(&step, gap <= gap_before + 1e-6 * (double)coeffs->z_max, "monotonic in d");
        gap_before = gap;
    }
    TEST_ASSERT_TRUE(gap_before == 0.0);
}

static void test_deflection_is_monotonic_in_the_displacement_up_to_2_z_max(void)
{
    sequence_t q;
    sequence_start(&q, SEQUENCE_RANDOM_WALK, 8);
    for (long i = 0; i < EFFORT(4000L); i++) {
        const int contact = (int)i % (PARAMETER_SETS * UPDATE_RULES);
        const epf_params_t params = parameters_by((epf_update_t)(contact % UPDATE_RULES),
                                                  &parameter_sets[contact / UPDATE_RULES]);
        epf_f32_coeffs_t coeffs;
        TEST_ASSERT_EQUAL_INT(EPF_OK, epf_f32_coeffs_init(&coeffs, &params));
        const float start = coeffs.z_max * (float)sequence_uniform(&q, -1.0, 1.0);
        const float v = params.v_s * (float)sequence_uniform(&q, 0.0, 4.0);
        ends_further_on_the_longer_it_is(&coeffs, &params, start, v);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_proposition_a_below_z_ss_deflection_rises_by_no_more_than_the_displacement);
    RUN_TEST(test_proposition_b_motion_is_elastic_up_to_z_ba);
    RUN_TEST(test_proposition_c_above_z_ss_deflection_goes_towards_it_and_not_beyond);
    RUN_TEST(test_proposition_d_every_displacement_closes_its_share_of_the_gap);
    RUN_TEST(test_proposition_c_holds_for_displacements_of_every_exponent);
    RUN_TEST(test_proposition_holds_where_the_plastic_region_is_below_a_rounding_of_z);
    RUN_TEST(test_deflection_is_monotonic_in_the_displacement_up_to_2_z_max);
    return UNITY_END() != 0;
}
