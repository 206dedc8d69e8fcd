/* SPDX-License-Identifier: MIT */
/*
 * The lemmas and theorems in integers, by both update rules, over the sequences of every contact and over
 * the corners of the parameters: fixed_properties.h says what is checked of each step. Then what takes
 * many steps.
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
    fixed_walk(1600, property);
    fixed_walk_corners(20, property);
    fixed_scatter(20, property);
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

static void test_theorem2_every_step_from_above_leads_towards_steady_state_and_not_beyond(void)
{
    holds(approaches_steady_state_from_above);
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
   term that is larger than sigma_0 z where z is below 10^7 */
static const fixed_variant_t *use_integers(int way, int32_t z_c, any_coeffs_t *coeffs)
{
    const fixed_variant_t *variant = fixed_way_variant(way);
    const epf_params_t params = {
        1.0f, 1e7f, 0.0f, (float)z_c, 1e9f, 1.0f, 1.0f, EPF_STRIBECK_COULOMB, fixed_way_rule(way)};
    const epf_lsb_t lsb = {1.0f, 1.0f, 1e5f, 1.0f};
    TEST_ASSERT_EQUAL_INT(EPF_OK, variant->coeffs_init(coeffs, &params, &lsb));
    const fixed_lengths_t c = variant->lengths(coeffs);
    TEST_ASSERT_EQUAL_INT(0, c.z_shift);
    TEST_ASSERT_EQUAL_INT32(z_c, c.z_c);
    return variant;
}

/* ---- Theorem 2 ------------------------------------------------------------------------------ */

/* Counts of the displacement that are needed from z to exactly `end`, and then stays there */
static long steps_to(const fixed_variant_t *variant, any_contact_t *ep, int32_t dx, int32_t end,
                     long most)
{
    long steps = 0;
    while (variant->z(ep) != end && steps < most) {
        (void)variant->advance(ep, dx);
        steps++;
    }
    (void)variant->advance(ep, dx);
    return variant->z(ep) == end ? steps : most + 1;
}

/*
 * Exactly z_ss, for every step of at least one count. From below the bound on the steps is that of
 * theorem2_f32, with 2^-30 for the smallest number and 2^-15 for the resolution of alpha in q15. From above
 * one step of the mean-value rule leaves exp(-d/z_ss) of 2^30 u, and less than one u is none: ln 2^30 and 1
 * steps of z_ss.
 */
static void reaches_steady_state(int way, const parameter_set_t *set, float counts_in_z_ba,
                                 int32_t dx, int32_t v)
{
    const fixed_variant_t *variant = fixed_way_variant(way);
    const epf_params_t params = parameters_by(fixed_way_rule(way), set);
    const epf_lsb_t lsb = {params.z_ba / counts_in_z_ba, params.v_s / 150.0f, params.f_max / 2e4f,
                           1e-5f};
    any_coeffs_t coeffs;
    any_contact_t ep;
    TEST_ASSERT_EQUAL_INT(EPF_OK, variant->coeffs_init(&coeffs, &params, &lsb));
    const fixed_lengths_t c = variant->lengths(&coeffs);
    variant->init(&ep, &coeffs);
    variant->set_velocity(&ep, v);
    const int s = dx > 0 ? 1 : -1;
    const int32_t end = s * variant->z_ss(&ep);
    const double steps_of_z_max = c.z_max / (fabs((double)dx) * (double)c.unit);
    const long most_from_below = (long)(60.0 * steps_of_z_max + 2.0);
    const long most_from_above =
        params.update == EPF_UPDATE_SATURATED ? 1 : (long)(22.0 * steps_of_z_max + 2.0);
    variant->reset(&ep, -s * c.z_max);
    TEST_ASSERT_TRUE_MESSAGE(steps_to(variant, &ep, dx, end, most_from_below) <= most_from_below,
                             set->name);
    variant->reset(&ep, s * c.z_max);
    TEST_ASSERT_TRUE_MESSAGE(steps_to(variant, &ep, dx, end, most_from_above) <= most_from_above,
                             set->name);
}

/* Not a million counts one by one, and on an emulated core by far */
static int32_t larger(int32_t dx)
{
    const int32_t least = 5 + 40 * (EPF_TEST_ONE_IN - 1);
    return dx > 0 ? (int32_t)fmax(dx, least) : (int32_t)fmin(dx, -least);
}

static void test_theorem2_every_count_leads_exactly_to_steady_state_from_below_and_from_above(void)
{
    static const int32_t steps[] = {1, -1, 2, 7, -100, 30000};
    const float many_counts = fmaxf(1.0f, EFFORT(300.0f));
    for (int way = 0; way < FIXED_WAYS; way++) {
        for (int set = 0; set < PARAMETER_SETS; set++) {
            for (int j = 0; j < 6 * 3; j++) {
                const int32_t v = (int32_t[]){0, 150, -5000}[j / 6];
                const bool fine = set == 6; /* z_max is a million z_ba */
                reaches_steady_state(way, &parameter_sets[set], fine ? 1.0f : many_counts,
                                     fine ? larger(steps[j % 6]) : steps[j % 6], v);
            }
        }
    }
}

/* Of d = 1 no part can be plastic without standing still */
static void test_theorem2_every_unit_below_steady_state_makes_progress(void)
{
    const int32_t end = INT32_C(1048576);
    for (int way = 0; way < FIXED_WAYS; way++) {
        any_coeffs_t coeffs;
        any_contact_t ep;
        const fixed_variant_t *variant = use_integers(way, end, &coeffs);
        variant->init(&ep, &coeffs);
        variant->set_velocity(&ep, 1);
        for (int32_t z = 0; z < end; z += z < 1000 || z > end - 1000 ? 1 : 997) {
            variant->reset(&ep, z);
            TEST_ASSERT_EQUAL_INT32(z + 1, variant->advance(&ep, 1));
            variant->reset(&ep, -z);
            TEST_ASSERT_EQUAL_INT32(-z - 1, variant->advance(&ep, -1));
        }
    }
}

/* And above it, where a displacement is so small a part of z_ss that less than a unit of the excess goes */
static void test_theorem2_every_unit_above_steady_state_makes_progress(void)
{
    const int32_t end = INT32_C(1048576);
    for (int way = 0; way < FIXED_WAYS; way++) {
        any_coeffs_t coeffs;
        any_contact_t ep;
        const fixed_variant_t *variant = use_integers(way, end, &coeffs);
        const bool at_once = fixed_way_rule(way) == EPF_UPDATE_SATURATED;
        variant->init(&ep, &coeffs);
        variant->set_velocity(&ep, 1);
        for (int32_t excess = 1; excess < end / 2; excess += 1 + excess / 16) {
            variant->reset(&ep, end + excess);
            TEST_ASSERT_EQUAL_INT32(end + (at_once ? 0 : excess - 1), variant->advance(&ep, 1));
            variant->reset(&ep, -end - excess);
            TEST_ASSERT_EQUAL_INT32(-end - (at_once ? 0 : excess - 1), variant->advance(&ep, -1));
        }
    }
}

/* zeta + d is beyond 32 bits here, while the gap and the displacement are not. The paper's rule arrives. */
static void test_theorem2_nothing_wraps_where_a_displacement_just_below_a_leap_meets_z_ss(void)
{
    for (int way = 0; way < FIXED_WAYS; way++) {
        const fixed_variant_t *variant = fixed_way_variant(way);
        const epf_params_t params = {1.0f,
                                     0.0f,
                                     0.0f,
                                     32767.0f,
                                     32767.0f,
                                     1.0f,
                                     16e3f,
                                     EPF_STRIBECK_COULOMB,
                                     fixed_way_rule(way)};
        const epf_lsb_t lsb = {2.0f, 1.0f, 1.0f, 1.0f}; /* z_max is nearly 2^30 units */
        any_coeffs_t coeffs;
        any_contact_t ep;
        TEST_ASSERT_EQUAL_INT(EPF_OK, variant->coeffs_init(&coeffs, &params, &lsb));
        const fixed_lengths_t c = variant->lengths(&coeffs);
        const bool at_once = params.update == EPF_UPDATE_SATURATED;
        variant->init(&ep, &coeffs);
        const int32_t dx = (int32_t)c.leap - 1;
        for (int32_t z = c.z_max - 1; z > (int32_t)c.unit - c.z_max; z -= 999983) {
            variant->reset(&ep, z);
            const int32_t end = variant->advance(&ep, dx);
            TEST_ASSERT_TRUE(at_once ? end == c.z_max : end > z && end <= c.z_max);
            variant->reset(&ep, -z);
            TEST_ASSERT_EQUAL_INT32(-end, variant->advance(&ep, -dx));
        }
    }
}

/* ---- a longer displacement ------------------------------------------------------------------- */

/* From z, over all displacements in ascending order up to one of 2 z_max and more: none ends farther from
   z_ss than a shorter one, but for the rounding of the fractions in the mean-value rule */
static void comes_no_less_far(int way, const any_coeffs_t *coeffs, int32_t z, int32_t v)
{
    const fixed_variant_t *variant = fixed_way_variant(way);
    const fixed_lengths_t c = variant->lengths(coeffs);
    const int32_t ripple = variant->ripple[fixed_way_rule(way)];
    any_contact_t ep;
    variant->init(&ep, coeffs);
    variant->set_velocity(&ep, v);
    const int32_t z_ss = variant->z_ss(&ep);
    const uint32_t leap = c.leap;
    int32_t nearest = INT32_MAX;
    for (uint32_t d = 1; d < leap; d += 1 + EPF_TEST_ONE_IN / 4 + leap / 20000) {
        variant->reset(&ep, z);
        const int32_t end = variant->advance(&ep, (int32_t)d);
        const int32_t distance = z < z_ss ? z_ss - end : end - z_ss;
        TEST_ASSERT_TRUE(distance <= nearest || distance - nearest <= ripple);
        nearest = distance < nearest ? distance : nearest;
    }
    variant->reset(&ep, z);
    TEST_ASSERT_EQUAL_INT32(z_ss, variant->advance(&ep, (int32_t)leap));
}

static void comes_no_less_far_from_anywhere(int way, const parameter_set_t *set, float counts)
{
    const fixed_variant_t *variant = fixed_way_variant(way);
    const epf_params_t params = parameters_by(fixed_way_rule(way), set);
    const epf_lsb_t lsb = {params.f_max / params.sigma_0 / counts, params.v_s / 150.0f,
                           params.f_max / 2e4f, 1e-5f};
    any_coeffs_t coeffs;
    if (variant->coeffs_init(&coeffs, &params, &lsb) != EPF_OK) {
        return; /* z_ba is below one count */
    }
    const fixed_lengths_t c = variant->lengths(&coeffs);
    for (int32_t i = -8; i <= 8; i += EPF_TEST_ONE_IN > 1 ? 4 : 1) {
        comes_no_less_far(way, &coeffs, c.z_max / 8 * i, i % 2 == 0 ? 1 : 3000);
    }
}

static void test_longer_displacement_comes_no_less_far_up_to_2_z_max_which_arrives(void)
{
    for (int way = 0; way < FIXED_WAYS; way++) {
        for (int set = 0; set < PARAMETER_SETS; set++) {
            comes_no_less_far_from_anywhere(way, &parameter_sets[set], 300.0f);
            comes_no_less_far_from_anywhere(way, &parameter_sets[set], 16000.0f);
        }
    }
}

/* ---- Theorem 3 at the edge of the guard ------------------------------------------------------ */

/* What is left of sigma_0 z by the damping term, where there is no viscous term, in case 1 */
static int64_t left_by_the_guard(int way, int32_t z_c)
{
    any_coeffs_t coeffs;
    any_contact_t ep;
    const fixed_variant_t *variant = use_integers(way, z_c, &coeffs);
    variant->init(&ep, &coeffs);
    variant->reset(&ep, z_c + 1);
    (void)variant->step(&ep, 1, 1, 1);
    TEST_ASSERT_EQUAL_INT32(z_c, variant->z(&ep));
    return variant->internal_force(&ep, 1);
}

static void test_theorem3_force_is_positive_where_the_damping_term_meets_nothing_but_a_small_z(void)
{
    for (int way = 0; way < FIXED_WAYS; way++) {
        const int32_t stride = 1 + EPF_TEST_ONE_IN / 100;
        for (int32_t z_c = 2; z_c < 4000000; z_c += z_c < 1100 ? stride : 1 + z_c / 7) {
            const int64_t left = left_by_the_guard(way, z_c);
            TEST_ASSERT_TRUE(left > 0);
            TEST_ASSERT_TRUE(left >= z_c / 1024);
            TEST_ASSERT_TRUE(left <= z_c / 1024 + 3 * 256); /* and the guard takes no more */
        }
        for (int32_t z_c = 256; z_c <= INT32_C(524288); z_c *= 2) {
            TEST_ASSERT_TRUE(left_by_the_guard(way, z_c) > 0);
        }
    }
}

/* ---- drift ---------------------------------------------------------------------------------- */

static void test_drift_tremor_returns_exactly(void)
{
    static const int32_t counts[] = {3, 5, -2, 7, -1, -9, 4, -6, 1, -2};
    const long cycles = EFFORT_SQUARED(5000000L);
    for (int way = 0; way < FIXED_WAYS; way++) {
        const fixed_variant_t *variant = fixed_way_variant(way);
        const epf_params_t params = parameters_by(fixed_way_rule(way), &parameter_sets[way]);
        const epf_lsb_t lsb = {params.z_ba / 40.0f, params.v_s / 150.0f, params.f_max / 2e4f,
                               1e-5f};
        any_coeffs_t coeffs;
        any_contact_t ep;
        TEST_ASSERT_EQUAL_INT(EPF_OK, variant->coeffs_init(&coeffs, &params, &lsb));
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
    RUN_TEST(test_theorem2_every_step_from_above_leads_towards_steady_state_and_not_beyond);
    RUN_TEST(test_theorem2_displacement_of_2_z_max_arrives_at_once);
    RUN_TEST(test_theorem3_plastic_displacement_dissipates_for_every_sigma_1);
    RUN_TEST(test_theorem4_no_step_yields_more_energy_than_was_stored);
    RUN_TEST(test_published_force_is_the_returned_one_and_has_the_sign_of_the_internal_one);
    RUN_TEST(test_rejected_counts_times_of_0_and_nothing_else);
    RUN_TEST(test_split_calls_and_step_leave_the_same_bits_in_every_field);
    RUN_TEST(test_oddness_negated_inputs_negate_outputs_exactly);
    RUN_TEST(test_theorem2_every_count_leads_exactly_to_steady_state_from_below_and_from_above);
    RUN_TEST(test_theorem2_every_unit_below_steady_state_makes_progress);
    RUN_TEST(test_theorem2_every_unit_above_steady_state_makes_progress);
    RUN_TEST(test_theorem2_nothing_wraps_where_a_displacement_just_below_a_leap_meets_z_ss);
    RUN_TEST(test_longer_displacement_comes_no_less_far_up_to_2_z_max_which_arrives);
    RUN_TEST(test_theorem3_force_is_positive_where_the_damping_term_meets_nothing_but_a_small_z);
    RUN_TEST(test_drift_tremor_returns_exactly);
    return UNITY_END() != 0;
}
