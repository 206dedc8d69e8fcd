/* SPDX-License-Identifier: MIT */
/*
 * The lemmas and theorems in integers, over the sequences of every contact and over the corners of the
 * parameters: fixed_properties.h says what is checked of each step. Then what takes many steps.
 */
#include "effort.h"
#include "fixed_properties.h"
#include "fixed_walk.h"
#include "parameter_sets.h"
#include "unity.h"

#include <math.h>

void setUp(void)
{
}

void tearDown(void)
{
}

static void holds(fixed_visitor_t property)
{
    fixed_walk(3000, property);
    fixed_walk_corners(60, property);
}

/* ---- of one step ---------------------------------------------------------------------------- */

static void test_theorem1_state_is_bounded_for_any_sequence(void)
{
    holds(state_is_bounded);
}

static void test_lemma1_deflection_is_between_nothing_and_displacement(void)
{
    holds(deflects_by_part_of_the_displacement);
}

static void test_lemma2_plastic_displacement_has_the_direction_of_motion(void)
{
    holds(plastic_displacement_follows_the_motion);
}

static void test_elastic_identity_holds_to_the_unit(void)
{
    holds(elastic_displacement_is_all_deflection);
}

static void test_theorem2_displacement_of_2_z_max_arrives_at_once(void)
{
    holds(leap_arrives);
}

static void test_theorem3_plastic_displacement_dissipates_for_every_sigma_1(void)
{
    holds(force_opposes_plastic_motion);
}

static void test_theorem4_no_step_yields_more_energy_than_was_stored(void)
{
    holds(no_step_yields_energy);
}

static void test_published_force_is_the_returned_one_and_has_the_sign_of_the_internal_one(void)
{
    holds(published_force_is_the_rounded_one);
}

static void test_rejected_counts_times_of_0_and_nothing_else(void)
{
    holds(rejected_counts_times_of_0);
}

static void test_split_calls_and_step_leave_the_same_bits_in_every_field(void)
{
    holds(split_calls_leave_the_same_contact);
}

static void test_oddness_negated_inputs_negate_outputs_exactly(void)
{
    holds(negated_inputs_negate_outputs);
}

/* ---- a contact in integers ------------------------------------------------------------------- */

/* A contact in integers: sigma_0 lsb.x = 1 N, z_shift 0, z_ba one count, f_max 10^9 N, and a damping
   term that saturates */
static void use_integers(const fixed_variant_t *variant, int32_t z_c, any_coeffs_t *coeffs)
{
    const epf_params_t params = {
        1.0f, 1e6f, 0.0f, (float)z_c, 1e9f, 1.0f, 1.0f, EPF_STRIBECK_COULOMB, EPF_UPDATE_SATURATED};
    const epf_lsb_t lsb = {1.0f, 1.0f, 1e5f, 1.0f};
    TEST_ASSERT_EQUAL_INT(EPF_OK, variant->coeffs_init(coeffs, &params, &lsb));
    const fixed_lengths_t c = variant->lengths(coeffs);
    TEST_ASSERT_EQUAL_INT(0, c.z_shift);
    TEST_ASSERT_EQUAL_INT32(z_c, c.z_c);
}

/* ---- Theorem 2 ------------------------------------------------------------------------------ */

/* Exactly z_ss, for every step of at least one count; the bound on the steps is that of theorem2_f32,
   with 2^-30 for the smallest number and 2^-15 for the resolution of alpha in q15 */
static void reaches_steady_state(const fixed_variant_t *variant, const parameter_set_t *set,
                                 float counts_in_z_ba, int32_t dx, int32_t v)
{
    const epf_lsb_t lsb = {set->params.z_ba / counts_in_z_ba, set->params.v_s / 150.0f,
                           set->params.f_max / 2e4f, 1e-5f};
    any_coeffs_t coeffs;
    any_contact_t ep;
    TEST_ASSERT_EQUAL_INT(EPF_OK, variant->coeffs_init(&coeffs, &set->params, &lsb));
    const fixed_lengths_t c = variant->lengths(&coeffs);
    variant->init(&ep, &coeffs);
    variant->reset(&ep, dx > 0 ? -c.z_max : c.z_max);
    variant->set_velocity(&ep, v);
    const int32_t end = dx > 0 ? variant->z_ss(&ep) : -variant->z_ss(&ep);
    const double steps = 60.0 * c.z_max / (fabs((double)dx) * (double)c.unit) + 2.0;
    for (long i = 0; i < (long)steps && variant->z(&ep) != end; i++) {
        (void)variant->advance(&ep, dx);
    }
    TEST_ASSERT_EQUAL_INT32_MESSAGE(end, variant->z(&ep), set->name);
    (void)variant->advance(&ep, dx);
    TEST_ASSERT_EQUAL_INT32_MESSAGE(end, variant->z(&ep), set->name); /* and it stays */
}

/* Not a million counts one by one on an emulated core */
static int32_t larger(int32_t dx)
{
    const int32_t least = 10 * (EPF_TEST_ONE_IN - 1); /* on a host, none */
    return dx > 0 ? (int32_t)fmax(dx, least) : (int32_t)fmin(dx, -least);
}

static void test_theorem2_every_count_leads_exactly_to_steady_state(void)
{
    static const int32_t steps[] = {1, -1, 2, 7, -100, 30000};
    const float many_counts = fmaxf(1.0f, EFFORT(300.0f));
    for (int i = 0; i < FIXED_VARIANTS; i++) {
        for (int set = 0; set < PARAMETER_SETS; set++) {
            for (int j = 0; j < 6 * 3; j++) {
                const int32_t v = (int32_t[]){0, 150, -5000}[j / 6];
                const bool fine = set == 6; /* z_max is a million z_ba */
                reaches_steady_state(fixed_variants[i], &parameter_sets[set],
                                     fine ? 1.0f : many_counts,
                                     fine ? larger(steps[j % 6]) : steps[j % 6], v);
            }
        }
    }
}

/* Of d = 1 no part can be plastic without standing still */
static void test_theorem2_every_unit_below_steady_state_makes_progress(void)
{
    const int32_t end = INT32_C(1048576);
    for (int i = 0; i < FIXED_VARIANTS; i++) {
        const fixed_variant_t *variant = fixed_variants[i];
        any_coeffs_t coeffs;
        any_contact_t ep;
        use_integers(variant, end, &coeffs);
        variant->init(&ep, &coeffs);
        variant->set_velocity(&ep, 1);
        for (int32_t z = 1; z < end; z += z < 1000 || z > end - 1000 ? 1 : 997) {
            variant->reset(&ep, z);
            TEST_ASSERT_EQUAL_INT32(z + 1, variant->advance(&ep, 1));
            variant->reset(&ep, -z);
            TEST_ASSERT_EQUAL_INT32(-z - 1, variant->advance(&ep, -1));
        }
    }
}

/* zeta + d is beyond 32 bits here, while the gap and the displacement are not */
static void test_theorem2_nothing_wraps_where_a_displacement_just_below_a_leap_meets_z_ss(void)
{
    for (int i = 0; i < FIXED_VARIANTS; i++) {
        const fixed_variant_t *variant = fixed_variants[i];
        const epf_params_t params = {1.0f,
                                     0.0f,
                                     0.0f,
                                     32767.0f,
                                     32767.0f,
                                     1.0f,
                                     16e3f,
                                     EPF_STRIBECK_COULOMB,
                                     EPF_UPDATE_SATURATED};
        const epf_lsb_t lsb = {2.0f, 1.0f, 1.0f, 1.0f}; /* z_max is nearly 2^30 units */
        any_coeffs_t coeffs;
        any_contact_t ep;
        TEST_ASSERT_EQUAL_INT(EPF_OK, variant->coeffs_init(&coeffs, &params, &lsb));
        const fixed_lengths_t c = variant->lengths(&coeffs);
        variant->init(&ep, &coeffs);
        const int32_t dx = (int32_t)c.leap - 1;
        for (int32_t z = c.z_max - 1; z > (int32_t)c.unit - c.z_max; z -= 999983) {
            variant->reset(&ep, z);
            TEST_ASSERT_EQUAL_INT32(c.z_max, variant->advance(&ep, dx));
            variant->reset(&ep, -z);
            TEST_ASSERT_EQUAL_INT32(-c.z_max, variant->advance(&ep, -dx));
        }
    }
}

/* ---- Theorem 3 at the edge of the guard ------------------------------------------------------ */

/* What is left of sigma_0 z by the damping term, where there is no viscous term */
static int64_t left_by_the_guard(const fixed_variant_t *variant, int32_t z_c)
{
    any_coeffs_t coeffs;
    any_contact_t ep;
    use_integers(variant, z_c, &coeffs);
    variant->init(&ep, &coeffs);
    variant->reset(&ep, INT32_MAX);
    (void)variant->step(&ep, 1, 1, 1); /* case 1: from z_max to z_c */
    TEST_ASSERT_EQUAL_INT32(z_c, variant->z(&ep));
    return variant->internal_force(&ep, 1);
}

static void test_theorem3_force_is_positive_where_the_damping_term_meets_nothing_but_a_small_z(void)
{
    for (int i = 0; i < FIXED_VARIANTS; i++) {
        for (int32_t z_c = 2; z_c < 4000000; z_c += z_c < 1100 ? 1 : 1 + z_c / 7) {
            const int64_t left = left_by_the_guard(fixed_variants[i], z_c);
            TEST_ASSERT_TRUE(left > 0);
            TEST_ASSERT_TRUE(left >= z_c / 1024);
            TEST_ASSERT_TRUE(left <= z_c / 1024 + 3 * 256); /* and the guard takes no more */
        }
        for (int32_t z_c = 256; z_c <= INT32_C(524288); z_c *= 2) {
            TEST_ASSERT_TRUE(left_by_the_guard(fixed_variants[i], z_c) > 0);
        }
    }
}

/* ---- drift ---------------------------------------------------------------------------------- */

static void test_drift_tremor_returns_exactly(void)
{
    static const int32_t counts[] = {3, 5, -2, 7, -1, -9, 4, -6, 1, -2};
    const long cycles = EFFORT_SQUARED(10000000L);
    for (int i = 0; i < FIXED_VARIANTS; i++) {
        const fixed_variant_t *variant = fixed_variants[i];
        const parameter_set_t *set = &parameter_sets[i];
        const epf_lsb_t lsb = {set->params.z_ba / 40.0f, set->params.v_s / 150.0f,
                               set->params.f_max / 2e4f, 1e-5f};
        any_coeffs_t coeffs;
        any_contact_t ep;
        TEST_ASSERT_EQUAL_INT(EPF_OK, variant->coeffs_init(&coeffs, &set->params, &lsb));
        variant->init(&ep, &coeffs);
        const int32_t start = variant->lengths(&coeffs).z_ba / 3;
        variant->reset(&ep, start);
        for (long j = 0; j < 10 * cycles; j++) {
            (void)variant->advance(&ep, counts[j % 10]);
        }
        TEST_ASSERT_EQUAL_INT32(start, variant->z(&ep));
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_theorem1_state_is_bounded_for_any_sequence);
    RUN_TEST(test_lemma1_deflection_is_between_nothing_and_displacement);
    RUN_TEST(test_lemma2_plastic_displacement_has_the_direction_of_motion);
    RUN_TEST(test_elastic_identity_holds_to_the_unit);
    RUN_TEST(test_theorem2_displacement_of_2_z_max_arrives_at_once);
    RUN_TEST(test_theorem3_plastic_displacement_dissipates_for_every_sigma_1);
    RUN_TEST(test_theorem4_no_step_yields_more_energy_than_was_stored);
    RUN_TEST(test_published_force_is_the_returned_one_and_has_the_sign_of_the_internal_one);
    RUN_TEST(test_rejected_counts_times_of_0_and_nothing_else);
    RUN_TEST(test_split_calls_and_step_leave_the_same_bits_in_every_field);
    RUN_TEST(test_oddness_negated_inputs_negate_outputs_exactly);
    RUN_TEST(test_theorem2_every_count_leads_exactly_to_steady_state);
    RUN_TEST(test_theorem2_every_unit_below_steady_state_makes_progress);
    RUN_TEST(test_theorem2_nothing_wraps_where_a_displacement_just_below_a_leap_meets_z_ss);
    RUN_TEST(test_theorem3_force_is_positive_where_the_damping_term_meets_nothing_but_a_small_z);
    RUN_TEST(test_drift_tremor_returns_exactly);
    return UNITY_END() != 0;
}
