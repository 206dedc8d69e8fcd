/* SPDX-License-Identifier: MIT */
/* The contract of f32.h beyond the equations: bad input, contexts, constant coefficients, bytes. */
#include "effort.h"
#include "epf/epf.h"
#include "f32_walk.h"
#include "parameter_sets.h"
#include "sequences.h"
#include "unity.h"

#include <math.h>
#include <string.h>
#ifdef __SSE__
#include <xmmintrin.h>
#endif

#define TABLE_2(rule) 1e5f, 1e3f, 0.4f, 1.0f, 1.5f, 1e-3f, 8e-6f, EPF_STRIBECK_LORENTZIAN, rule

static const struct {
    epf_params_t params;
    epf_f32_coeffs_t coeffs;
} contacts[UPDATE_RULES] = {
    {{TABLE_2(EPF_UPDATE_SATURATED)}, EPF_F32_COEFFS(TABLE_2(EPF_UPDATE_SATURATED))},
    {{TABLE_2(EPF_UPDATE_MEAN_VALUE)}, EPF_F32_COEFFS(TABLE_2(EPF_UPDATE_MEAN_VALUE))},
};

/* All but the tests by hand are run by either rule */
static epf_update_t rule;
static epf_f32_coeffs_t table_2;
static epf_f32_t ep;

void setUp(void)
{
    table_2 = contacts[rule].coeffs;
    epf_f32_init(&ep, &table_2);
}

void tearDown(void)
{
}

static void test_coeffs_macro_equals_coeffs_init_bit_for_bit(void)
{
    epf_f32_coeffs_t made;
    TEST_ASSERT_EQUAL_INT(EPF_OK, epf_f32_coeffs_init(&made, &contacts[rule].params));
    TEST_ASSERT_TRUE(made.sigma_0 == table_2.sigma_0);
    TEST_ASSERT_TRUE(made.sigma_1 == table_2.sigma_1);
    TEST_ASSERT_TRUE(made.sigma_2 == table_2.sigma_2);
    TEST_ASSERT_TRUE(made.f_c == table_2.f_c);
    TEST_ASSERT_TRUE(made.f_max == table_2.f_max);
    TEST_ASSERT_TRUE(made.inv_v_s == table_2.inv_v_s);
    TEST_ASSERT_TRUE(made.z_ba == table_2.z_ba);
    TEST_ASSERT_TRUE(made.z_c == table_2.z_c);
    TEST_ASSERT_TRUE(made.z_max == table_2.z_max);
    TEST_ASSERT_EQUAL_INT(made.stribeck, table_2.stribeck);
    TEST_ASSERT_EQUAL_INT(made.update, rule);
    TEST_ASSERT_EQUAL_INT(made.update, table_2.update);
}

static void test_coeffs_carry_the_values_of_table_2(void)
{
    TEST_ASSERT_FLOAT_WITHIN(1e-10f, 1.0e-5f, table_2.z_c);
    TEST_ASSERT_FLOAT_WITHIN(1e-10f, 1.5e-5f, table_2.z_max);
    TEST_ASSERT_FLOAT_WITHIN(1e-10f, 0.8e-5f, table_2.z_ba);
    TEST_ASSERT_FLOAT_WITHIN(0.1f, 1000.0f, table_2.inv_v_s);
}

static void test_init_is_at_rest(void)
{
    TEST_ASSERT_TRUE(epf_f32_z(&ep) == 0.0f);
    TEST_ASSERT_TRUE(epf_f32_output(&ep) == 0.0f);
    TEST_ASSERT_EQUAL_UINT32(0, ep.rejected);
    TEST_ASSERT_TRUE(epf_f32_force(&ep, 1e-3f) == 0.0f);
}

/* A contact made of the fields of epf_params_t, on which a defect was found once */
static void use(epf_f32_coeffs_t *coeffs, const epf_params_t *params)
{
    TEST_ASSERT_EQUAL_INT(EPF_OK, epf_f32_coeffs_init(coeffs, params));
    epf_f32_init(&ep, coeffs);
}

/* By hand, Table II: z 4e-6 m; 1e5 * 4e-6 = 0.4 N; 1e3 * 4e-6/1e-3 = 4 N; 0.4 * 2e-3 = 0.0008 N */
static void test_step_by_hand_in_the_elastic_regime(void)
{
    TEST_ASSERT_FLOAT_WITHIN(1e-5f, 4.4008f, epf_f32_step(&ep, 4e-6f, 2e-3f, 1e-3f));
    TEST_ASSERT_FLOAT_WITHIN(1e-5f, 4.4008f, epf_f32_output(&ep));
    TEST_ASSERT_FLOAT_WITHIN(1e-12f, 4e-6f, epf_f32_z(&ep));
    /* back: z 1e-6; 0.1 - 3 - 0.0008 */
    TEST_ASSERT_FLOAT_WITHIN(1e-5f, -2.9008f, epf_f32_step(&ep, -3e-6f, 2e-3f, 1e-3f));
}

/* By hand: sliding at v_s, f_ss = 1 + 0.5/2 = 1.25 N; then faster, 3 v_s: f_ss = 1.05 N, case 1:
   the damping term 1e3 * (1.05e-5 - 1.25e-5)/1e-3 = -2 N is limited to (1 - 2^-10)(1.05 + 0.0012)
 */
static void test_step_by_hand_through_case_1_is_guarded(void)
{
    (void)epf_f32_step(&ep, 1e-3f, 1e-3f, 1e-3f);
    TEST_ASSERT_FLOAT_WITHIN(1e-11f, 1.25e-5f, epf_f32_z(&ep));
    TEST_ASSERT_FLOAT_WITHIN(1e-6f, 1.0512f / 1024.0f, epf_f32_step(&ep, 1e-6f, 3e-3f, 1e-3f));
    /* at 10 ms the damping term is -0.2 N, and passes */
    setUp();
    (void)epf_f32_step(&ep, 1e-3f, 1e-3f, 1e-2f);
    TEST_ASSERT_FLOAT_WITHIN(1e-6f, 0.8512f, epf_f32_step(&ep, 1e-6f, 3e-3f, 1e-2f));
}

/* By hand, the mean-value rule: as before, but over 4.2e-6 m, which is q = 0.4 of z_ss = 1.05e-5 m. With
   v = 0.1, h = 1 - 0.1 (1 - 0.0625) = 0.90625, q h^2 = 0.328516 of the 2e-6 m above z_ss go: 6.57031e-7 m.
   f = 1.184297 + 0.0012 - 0.0657031 N in 10 ms; in 0.1 ms the damping term is -6.57 N, and is limited */
static void test_step_by_hand_through_case_1_lets_go_in_part(void)
{
    (void)epf_f32_step(&ep, 1e-3f, 1e-3f, 1e-2f);
    TEST_ASSERT_FLOAT_WITHIN(1e-11f, 1.25e-5f, epf_f32_z(&ep));
    TEST_ASSERT_FLOAT_WITHIN(2e-6f, 1.119794f, epf_f32_step(&ep, 4.2e-6f, 3e-3f, 1e-2f));
    TEST_ASSERT_FLOAT_WITHIN(1e-11f, 1.1842969e-5f, epf_f32_z(&ep));
    TEST_ASSERT_FLOAT_WITHIN(1e-8f, 1.185497f / 1024.0f, epf_f32_force(&ep, 1e-4f));
}

/*
 * By hand, z_ss = 1 and z_ba = 1/2. From 3/4 over 1/4: u = 1/2, p = 1/8, w = 27/64, b = 0.870941, v = 0.148403,
 * h^2 = 0.748851, so that (12) is taken at 1 - h^2/4 = 0.812787: alpha = 0.692175, y = 0.437409/4.
 * From 1/4 over 1/2, of which half is elastic: u = 1, p = 1/8, w = 27/32, b = 1.163452, v = 0.146578,
 * h^2 = 0.751429, taken at 1 - h^2/2 = 0.624286: alpha = 0.144861, y = 1/4 + 0.909565/4.
 */
static void test_advance_by_hand_with_the_mean_value_rule(void)
{
    const epf_params_t params = {1.0f, 0.0f, 0.0f, 1.0f, 1.0f, 1e-3f, 0.5f, EPF_STRIBECK_LORENTZIAN,
                                 rule};
    epf_f32_coeffs_t coeffs;
    use(&coeffs, &params);
    for (int s = -1; s <= 1; s += 2) {
        epf_f32_reset(&ep, 0.75f * (float)s);
        TEST_ASSERT_FLOAT_WITHIN(2e-6f, (float)s * 0.859352f,
                                 epf_f32_advance(&ep, 0.25f * (float)s));
        epf_f32_reset(&ep, 0.25f * (float)s);
        TEST_ASSERT_FLOAT_WITHIN(2e-6f, (float)s * 0.727391f,
                                 epf_f32_advance(&ep, 0.5f * (float)s));
    }
}

/* Case 1 under the guard, left on the way to z_ss */
static int is_guarded_on_the_way(void)
{
    const float s = (float)ep.direction, z_ss = ep.points[ep.published].z_ss;
    return s * ep.dz < 0.0f && s * ep.z != z_ss &&
           s * ep.force < 1.5f / 1024.0f * table_2.sigma_0 * s * ep.z;
}

static void same_bits(float a, float b)
{
    TEST_ASSERT_EQUAL_MEMORY(&a, &b, sizeof a);
}

static void same_state(const epf_f32_t *a, const epf_f32_t *b)
{
    same_bits(a->z, b->z);
    same_bits(a->z_low, b->z_low);
    same_bits(a->dz, b->dz);
    same_bits(a->force, b->force);
    TEST_ASSERT_EQUAL_INT(a->direction, b->direction);
    TEST_ASSERT_EQUAL_UINT32(a->rejected, b->rejected);
    TEST_ASSERT_EQUAL_MEMORY(&a->points[a->published], &b->points[b->published],
                             sizeof a->points[0]);
}

static void test_step_has_the_bits_of_set_velocity_advance_and_force(void)
{
    int guarded_on_the_way = 0;
    for (int kind = 0; kind < SEQUENCE_KINDS; kind++) {
        epf_f32_t other;
        sequence_t q;
        setUp();
        epf_f32_init(&other, &table_2);
        sequence_start(&q, (sequence_kind_t)kind, 3);
        for (long i = 0; i < EFFORT(20000L) + 100; i++) {
            const sample_t sample = sequence_next(&q);
            const float dx = f32_from_double(sample.dx * (double)table_2.z_max);
            const float v = f32_from_double(sample.v * 1e-3);
            const float force = epf_f32_step(&ep, dx, v, (float)sample.dt);
            epf_f32_set_velocity(&other, v);
            same_bits(epf_f32_z(&ep), epf_f32_advance(&other, dx));
            same_bits(force, epf_f32_force(&other, (float)sample.dt));
            same_bits(force, epf_f32_output(&other));
            same_state(&ep, &other);
            guarded_on_the_way += is_guarded_on_the_way();
        }
    }
    TEST_ASSERT_TRUE((guarded_on_the_way > 0) == (rule == EPF_UPDATE_MEAN_VALUE));
}

static void test_reset_clamps_and_publishes_the_force_of_a_contact_at_rest(void)
{
    epf_f32_reset(&ep, 1.0f);
    TEST_ASSERT_TRUE(epf_f32_z(&ep) == table_2.z_max);
    TEST_ASSERT_FLOAT_WITHIN(1e-6f, 1.5f, epf_f32_output(&ep));
    epf_f32_reset(&ep, -INFINITY);
    TEST_ASSERT_TRUE(epf_f32_z(&ep) == -table_2.z_max);
    epf_f32_reset(&ep, 3e-6f);
    TEST_ASSERT_TRUE(epf_f32_z(&ep) == 3e-6f);
    TEST_ASSERT_EQUAL_UINT32(0, ep.rejected);
    epf_f32_reset(&ep, NAN);
    TEST_ASSERT_TRUE(epf_f32_z(&ep) == 0.0f);
    TEST_ASSERT_EQUAL_UINT32(1, ep.rejected);
}

/* Also what z had beyond float precision is gone */
static void test_reset_leaves_nothing_of_the_past(void)
{
    epf_f32_t fresh;
    epf_f32_init(&fresh, &table_2);
    epf_f32_reset(&fresh, 3e-6f);
    (void)epf_f32_update(&ep, 4e-6f, 0.0f);
    (void)epf_f32_update(&ep, 1.3e-13f, 0.0f);
    epf_f32_reset(&ep, 3e-6f);
    TEST_ASSERT_TRUE(epf_f32_force(&ep, 1e-3f) == epf_f32_output(&fresh)); /* no damping either */
    for (int i = 0; i < 10; i++) {
        TEST_ASSERT_TRUE(epf_f32_advance(&ep, 1.7e-13f) == epf_f32_advance(&fresh, 1.7e-13f));
    }
}

/* The force of a contact at rest, to the bit: 1e5 * 3e-6, and 1e5 * z_max */
static void test_reset_publishes_sigma_0_z(void)
{
    epf_f32_reset(&ep, 3e-6f);
    TEST_ASSERT_TRUE(epf_f32_output(&ep) == 1e5f * 3e-6f);
    epf_f32_reset(&ep, INFINITY);
    TEST_ASSERT_TRUE(epf_f32_output(&ep) == 1e5f * table_2.z_max);
}

/* By hand: 0.4 N s/m at 2 m/s is 0.8 N, in the direction of v where no displacement tells another */
static void test_reset_forgets_the_direction_of_the_last_displacement(void)
{
    (void)epf_f32_step(&ep, -1e-6f, 2.0f, 1e-3f);
    epf_f32_reset(&ep, 0.0f);
    TEST_ASSERT_FLOAT_WITHIN(1e-6f, 0.8f, epf_f32_force(&ep, 1e-3f));
    epf_f32_set_velocity(&ep, -2.0f);
    TEST_ASSERT_FLOAT_WITHIN(1e-6f, -0.8f, epf_f32_force(&ep, 1e-3f));
    (void)epf_f32_advance(&ep, 1e-6f);
    TEST_ASSERT_FLOAT_WITHIN(1e-5f, 0.1f + 0.8f, epf_f32_force(&ep, 1e3f)); /* along dx again */
}

/* Where dx = 0 the viscous term has the sign of v, also of one that is set afterwards */
static void test_standstill_viscous_term_has_the_sign_of_v(void)
{
    (void)epf_f32_step(&ep, -1e-6f, 2.0f, 1e-3f);
    TEST_ASSERT_FLOAT_WITHIN(1e-6f, -0.1f + 0.8f, epf_f32_step(&ep, 0.0f, 2.0f, 1e-3f));
    epf_f32_set_velocity(&ep, -2.0f);
    TEST_ASSERT_FLOAT_WITHIN(1e-6f, -0.1f - 0.8f, epf_f32_force(&ep, 1e-3f));
    TEST_ASSERT_FLOAT_WITHIN(1e-6f, -0.1f + 0.8f, epf_f32_step(&ep, -0.0f, 2.0f, 1e-3f));
}

static void test_bad_displacement_nan_changes_nothing_and_is_counted(void)
{
    (void)epf_f32_step(&ep, 5e-6f, 1e-3f, 1e-3f);
    const epf_f32_t before = ep;
    TEST_ASSERT_TRUE(epf_f32_advance(&ep, NAN) == before.z);
    TEST_ASSERT_EQUAL_UINT32(1, ep.rejected);
    ep.rejected = before.rejected;
    TEST_ASSERT_EQUAL_MEMORY(&before, &ep, sizeof before);
}

static void test_bad_displacement_infinity_saturates(void)
{
    TEST_ASSERT_TRUE(epf_f32_update(&ep, INFINITY, 0.0f) == table_2.z_max);
    TEST_ASSERT_TRUE(epf_f32_update(&ep, -INFINITY, 0.0f) == -table_2.z_max);
    TEST_ASSERT_EQUAL_UINT32(0, ep.rejected);
}

/* A gap that is subnormal once had a share below 0, and infinity made NaN of it */
static void test_leap_over_a_subnormal_gap_arrives(void)
{
    const epf_params_t large = {
        1.0f, 0.0f, 0.0f, 1000.0f, 1100.0f, 1e-3f, 900.0f, EPF_STRIBECK_LORENTZIAN, rule};
    epf_f32_coeffs_t coeffs;
    use(&coeffs, &large);
    (void)epf_f32_step(&ep, INFINITY, 1e-3f, 1e-3f);
    (void)epf_f32_step(&ep, -5.26888e-43f, 1e-3f, 1e-3f);
    TEST_ASSERT_FLOAT_WITHIN(1e-3f, 1050.0f, epf_f32_step(&ep, INFINITY, 1e-3f, 1e-3f));
    TEST_ASSERT_FLOAT_WITHIN(1e-3f, 1050.0f, epf_f32_z(&ep));
    TEST_ASSERT_EQUAL_UINT32(0, ep.rejected);
}

static void test_leap_of_any_length_over_a_subnormal_gap_arrives(void)
{
    static const float leaps[] = {4.5f, 10.0f, 1e38f, FLT_MAX, INFINITY};
    const epf_params_t narrow = {
        1.0f, 0.0f, 0.0f, 2.25f, 2.25f, 1.0f, 2.25f - 1.0f / 3.0f, EPF_STRIBECK_LORENTZIAN, rule};
    epf_f32_coeffs_t coeffs;
    for (int i = 0; i < 5; i++) {
        use(&coeffs, &narrow);
        TEST_ASSERT_TRUE(epf_f32_update(&ep, 10.0f, 1.0f) == 2.25f);
        (void)epf_f32_update(&ep, -0x1p-149f, 1.0f);
        TEST_ASSERT_TRUE(epf_f32_update(&ep, leaps[i], 1.0f) == 2.25f);
        TEST_ASSERT_TRUE(ep.z_low == 0.0f);
    }
}

/* By hand: elastic 1e-10 * 1e20 = 1e10 N; damping 1e30 * 1e20/1e25 = 1e25 N, though 1e50 is no float */
static void test_force_damping_may_overflow_before_it_is_divided(void)
{
    const epf_params_t soft = {
        1e-10f, 1e30f, 0.0f, 1e11f, 1.1e11f, 1e-3f, 5e20f, EPF_STRIBECK_LORENTZIAN, rule};
    epf_f32_coeffs_t coeffs;
    use(&coeffs, &soft);
    (void)epf_f32_update(&ep, 1e20f, 0.0f);
    TEST_ASSERT_FLOAT_WITHIN(1e19f, 1e25f, epf_f32_force(&ep, 1e25f));
    use(&coeffs, &soft);
    TEST_ASSERT_FLOAT_WITHIN(1e19f, 1e25f, epf_f32_step(&ep, 1e20f, 0.0f, 1e25f));
    TEST_ASSERT_FLOAT_WITHIN(1e19f, -1e25f, epf_f32_step(&ep, -1e20f, 0.0f, 1e25f));
}

/* Next to overflow, too, what is negated comes out negated: 1e19 N s/m at 3e19 m/s, in the longest time */
static void test_force_is_odd_next_to_overflow(void)
{
    const epf_params_t viscous = {
        1.0f, 0.0f, 1e19f, 1.0f, 1.5f, 1e-3f, 0.5f, EPF_STRIBECK_LORENTZIAN, rule};
    epf_f32_coeffs_t coeffs;
    epf_f32_t mirror;
    use(&coeffs, &viscous);
    epf_f32_init(&mirror, &coeffs);
    const float force = epf_f32_step(&ep, 0.1f, 3e19f, FLT_MAX);
    TEST_ASSERT_TRUE(force > 0.0f && isfinite(force));
    TEST_ASSERT_TRUE(epf_f32_step(&mirror, -0.1f, -3e19f, FLT_MAX) == -force);
}

/* Sliding slower, then faster: the damping term is limited, whatever it is as a float: -1e40 N where all goes
   that can, and by the mean-value rule -1e20 N over 1 m */
static void test_force_guard_holds_where_damping_overflows(void)
{
    const epf_params_t soft = {
        1e-10f, 1e30f, 0.0f, 1e11f, 2e11f, 1e-3f, 5e20f, EPF_STRIBECK_LORENTZIAN, rule};
    epf_f32_coeffs_t coeffs;
    use(&coeffs, &soft);
    (void)epf_f32_step(&ep, INFINITY, 0.0f, 1.0f);
    const float newtons = rule == EPF_UPDATE_SATURATED ? 1e11f : 2e11f; /* what is elastic then */
    TEST_ASSERT_FLOAT_WITHIN(1e4f, newtons / 1024.0f, epf_f32_step(&ep, 1.0f, INFINITY, 1e10f));
    TEST_ASSERT_FLOAT_WITHIN(1e4f, newtons / 1024.0f, epf_f32_force(&ep, 1e10f));
    (void)epf_f32_step(&ep, INFINITY, 0.0f, 1.0f);
    TEST_ASSERT_FLOAT_WITHIN(1e4f, 1e11f / 1024.0f, epf_f32_step(&ep, INFINITY, INFINITY, 1e10f));
}

/* Theorem 3 with nothing but the elastic term, and with the smallest force of which 2^-10 is a float */
static void test_force_opposes_the_motion_where_all_other_terms_are_0(void)
{
    const epf_params_t bare = {1e5f, 0.0f, 0.0f, 1.0f, 1.5f, 1e-3f, 8e-6f, EPF_STRIBECK_LORENTZIAN,
                               rule};
    epf_params_t faint = {
        1.0f, FLT_MAX, 0.0f, 4.0f * FLT_MIN, 8.0f * FLT_MIN, 1e-3f, FLT_MIN, EPF_STRIBECK_COULOMB,
        rule};
    epf_f32_coeffs_t coeffs;
    for (int s = -1; s <= 1; s += 2) {
        use(&coeffs, &bare);
        (void)epf_f32_step(&ep, (float)s, 0.0f, 1e-3f);
        TEST_ASSERT_TRUE(epf_f32_step(&ep, (float)s, 1e3f, 1e-9f) == (float)s);
        use(&coeffs, &faint);
        (void)epf_f32_step(&ep, (float)s, 0.0f, 1.0f);
        const float force = epf_f32_step(&ep, (float)s, 1e3f, 1e-9f); /* case 1 */
        TEST_ASSERT_TRUE((float)s * force > 0.0f && (float)s * force <= FLT_MIN / 128.0f);
        TEST_ASSERT_TRUE(epf_f32_force(&ep, 1e-9f) == force);
    }
}

static void test_bad_velocity_nan_keeps_the_last_one_and_is_counted(void)
{
    epf_f32_t other;
    epf_f32_init(&other, &table_2);
    (void)epf_f32_update(&other, 1e-6f, 2e-3f);
    (void)epf_f32_update(&ep, 1e-6f, 2e-3f);
    TEST_ASSERT_TRUE(epf_f32_step(&ep, 3e-5f, NAN, 1e-3f) ==
                     epf_f32_step(&other, 3e-5f, 2e-3f, 1e-3f));
    TEST_ASSERT_EQUAL_UINT32(1, ep.rejected);
}

static void test_bad_velocity_infinity_is_the_high_speed_limit(void)
{
    TEST_ASSERT_TRUE(epf_f32_update(&ep, 1.0f, INFINITY) == table_2.z_c);
    TEST_ASSERT_TRUE(epf_f32_update(&ep, -1.0f, -INFINITY) == -table_2.z_c);
    TEST_ASSERT_TRUE(isfinite(epf_f32_force(&ep, 1e-3f)));
    TEST_ASSERT_EQUAL_UINT32(0, ep.rejected);
}

static void test_bad_time_removes_the_damping_term_and_is_counted(void)
{
    static const float bad[] = {0.0f, -0.0f, -1e-3f, NAN, INFINITY, -INFINITY};
    (void)epf_f32_update(&ep, 4e-6f, 2e-3f);
    for (unsigned i = 0; i < 6; i++) {
        TEST_ASSERT_FLOAT_WITHIN(1e-6f, 0.4008f, epf_f32_force(&ep, bad[i]));
        TEST_ASSERT_EQUAL_UINT32(i + 1, ep.rejected);
    }
}

/* Everything at its worst at once: the largest coefficients and inputs that are accepted */
static void test_bad_input_force_saturates_and_stays_finite(void)
{
    const epf_params_t giant = {
        1e36f, FLT_MAX, FLT_MAX, 1e37f, 2e37f, FLT_MIN, 1.0f, EPF_STRIBECK_GAUSSIAN, rule};
    static const float values[] = {0.0f, 1e-45f, FLT_MIN, 1.0f, 15.0f, FLT_MAX, INFINITY};
    epf_f32_coeffs_t coeffs;
    TEST_ASSERT_EQUAL_INT(EPF_OK, epf_f32_coeffs_init(&coeffs, &giant));
    epf_f32_init(&ep, &coeffs);
    for (int i = 0; i < 7 * 7 * 7 * 4; i++) {
        const float dx = values[i % 7] * (i % 2 ? -1.0f : 1.0f);
        const float v = values[i / 7 % 7] * (i / 686 ? -1.0f : 1.0f);
        const float leap = i % 2 ? INFINITY : -INFINITY; /* the largest dz, in the least time */
        TEST_ASSERT_TRUE(isfinite(epf_f32_step(&ep, leap, v, 1e-45f)));
        TEST_ASSERT_TRUE(isfinite(epf_f32_step(&ep, dx, v, values[i / 49 % 7])));
        TEST_ASSERT_TRUE(fabsf(epf_f32_z(&ep)) <= coeffs.z_max);
    }
}

static float random_bits(sequence_t *q)
{
    const uint32_t bits = (uint32_t)sequence_uniform(q, 0.0, 65536.0) << 16 |
                          (uint32_t)sequence_uniform(q, 0.0, 65536.0);
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* One good sample after any number of bad ones is a good sample */
static void test_bad_input_any_bits_leave_the_estimator_intact(void)
{
    sequence_t q;
    sequence_start(&q, SEQUENCE_EXTREMES, 11);
    uint32_t rejected = 0;
    for (long i = 0; i < EFFORT(300000L); i++) {
        const float dx = random_bits(&q);
        const float v = random_bits(&q);
        const float dt = random_bits(&q);
        TEST_ASSERT_TRUE(isfinite(epf_f32_step(&ep, dx, v, dt)));
        TEST_ASSERT_TRUE(fabsf(epf_f32_z(&ep)) <= table_2.z_max);
        TEST_ASSERT_TRUE(ep.rejected >= rejected);
        rejected = ep.rejected;
    }
    TEST_ASSERT_TRUE(rejected > 0);
    TEST_ASSERT_FLOAT_WITHIN(1e-4f, 1.2504f, epf_f32_step(&ep, 1e-4f, 1e-3f, 1e3f));
    TEST_ASSERT_FLOAT_WITHIN(1e-10f, 1.25e-5f, epf_f32_z(&ep));
}

/* Where it is after 1.5 z_c of motion at 100 v_s, as a share of z_c */
static float slid(const epf_params_t *p, int in_one_call)
{
    epf_f32_coeffs_t coeffs;
    epf_f32_t contact;
    TEST_ASSERT_EQUAL_INT(EPF_OK, epf_f32_coeffs_init(&coeffs, p));
    epf_f32_init(&contact, &coeffs);
    for (int i = 0; i < 30; i++) {
        if (in_one_call) {
            (void)epf_f32_step(&contact, coeffs.z_c / 20.0f, 1e-3f, 1e-3f);
        } else {
            (void)epf_f32_update(&contact, coeffs.z_c / 20.0f, 1e-3f);
        }
    }
    return epf_f32_z(&contact) / coeffs.z_c;
}

/* A contact knows no length but its own: one whose z_ss^2 overflows or vanishes does as a usual one */
static void test_range_contacts_of_any_size_move_alike(void)
{
    epf_params_t usual = {1e5f, 0.0f, 0.0f, 1.0f, 1.1f, 1e-5f, 5e-6f, EPF_STRIBECK_LORENTZIAN,
                          rule};
    epf_params_t small = usual, large = usual;
    small.f_c = large.f_c = 1e10f;
    small.f_max = large.f_max = 1.1e10f;
    small.sigma_0 = 1e35f;
    small.z_ba = 0.5e-25f;
    large.sigma_0 = 1e-10f;
    large.z_ba = 0.5e20f;
    for (int in_one_call = 0; in_one_call < 2; in_one_call++) {
        const float expected = slid(&usual, in_one_call);
        TEST_ASSERT_TRUE(expected > 0.9f && expected < 0.99f);
        TEST_ASSERT_FLOAT_WITHIN(1e-5f, expected, slid(&small, in_one_call));
        TEST_ASSERT_FLOAT_WITHIN(1e-5f, expected, slid(&large, in_one_call));
    }
}

/* Numbers with which z_c + (z_max - z_c) is rounded up */
static void test_coeffs_z_max_is_the_sum_that_z_ss_is_and_not_above(void)
{
    const epf_params_t p = {
        1.0f, 0.0f, 0.0f, 1.93080974f, 7.49889708f, 1e-3f, 1.0f, EPF_STRIBECK_LORENTZIAN, rule};
    epf_f32_coeffs_t c;
    TEST_ASSERT_EQUAL_INT(EPF_OK, epf_f32_coeffs_init(&c, &p));
    TEST_ASSERT_TRUE(c.z_c + c.z_excess == c.z_max);
    TEST_ASSERT_TRUE(c.z_max <= p.f_max);
    TEST_ASSERT_TRUE(epf_f32_fss(&c, 1e-20f) <= p.f_max);
}

/* Where subnormal numbers are flushed to zero: also in what is only read */
static void set_flush_to_zero(int on)
{
#if defined(__SSE__)
    _mm_setcsr(on ? _mm_getcsr() | 0x8040u : _mm_getcsr() & ~0x8040u);
#elif defined(__ARM_FP) && defined(__arm__)
    uint32_t fpscr;
    __asm volatile("vmrs %0, fpscr" : "=r"(fpscr));
    fpscr = on ? fpscr | 1u << 24 : fpscr & ~(1u << 24);
    __asm volatile("vmsr fpscr, %0" : : "r"(fpscr));
#else
    (void)on;
#endif
}

static uint32_t exponent_and_mantissa(float x)
{
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits & 0x7fffffffu;
}

/* The bounds are those of the bits, for comparisons are flushed as well */
static void test_flush_to_zero_promises_hold_for_any_bits(void)
{
    const epf_params_t small = {1.0f,
                                1e-3f,
                                1e-3f,
                                3.0f * FLT_MIN,
                                3.1f * FLT_MIN,
                                1e-3f,
                                2.0f * FLT_MIN,
                                EPF_STRIBECK_LORENTZIAN,
                                rule};
    epf_f32_coeffs_t coeffs;
    sequence_t q;
    sequence_start(&q, SEQUENCE_EXTREMES, 23);
    use(&coeffs, &small);
    const uint32_t z_max = exponent_and_mantissa(coeffs.z_max);
    uint32_t largest_z = 0, largest_force = 0, rejected = 0;
    for (long i = 0; i < EFFORT(100000L); i++) {
        const float scale = i % 2 ? 1.0f : 1e-30f;
        const float dx = random_bits(&q) * scale;
        const float v = random_bits(&q);
        const float dt = random_bits(&q);
        set_flush_to_zero(1);
        const uint32_t force = exponent_and_mantissa(epf_f32_step(&ep, dx, v, dt));
        set_flush_to_zero(0);
        largest_force = force > largest_force ? force : largest_force;
        const uint32_t z = exponent_and_mantissa(epf_f32_z(&ep));
        largest_z = z > largest_z ? z : largest_z;
        TEST_ASSERT_TRUE(ep.rejected >= rejected);
        rejected = ep.rejected;
    }
    TEST_ASSERT_TRUE(largest_z <= z_max);
    TEST_ASSERT_TRUE(largest_force < 0x7f800000u);
    set_flush_to_zero(1);
    const float z = epf_f32_update(&ep, 1.0f, 0.0f);
    set_flush_to_zero(0);
    TEST_ASSERT_TRUE(z >= coeffs.z_c && z <= coeffs.z_max);
}

/* A subnormal dt is one in IEEE arithmetic, and none where it is flushed: then it is counted */
static void test_flush_to_zero_subnormal_time_is_usable_or_counted(void)
{
    (void)epf_f32_update(&ep, 4e-6f, 2e-3f);
    TEST_ASSERT_TRUE(isfinite(epf_f32_force(&ep, 0x1p-140f)));
    TEST_ASSERT_EQUAL_UINT32(0, ep.rejected);
#if defined(__SSE__)
    set_flush_to_zero(1);
    const float force = epf_f32_force(&ep, 0x1p-140f);
    set_flush_to_zero(0);
    TEST_ASSERT_FLOAT_WITHIN(1e-6f, 0.4008f, force);
    TEST_ASSERT_EQUAL_UINT32(1, ep.rejected);
#endif
}

static void test_rejected_never_wraps(void)
{
    ep.rejected = UINT32_MAX - 1;
    (void)epf_f32_advance(&ep, NAN);
    (void)epf_f32_advance(&ep, NAN);
    TEST_ASSERT_EQUAL_UINT32(UINT32_MAX, ep.rejected);
}

/* An interrupt between the preparation and the publication of an operating point sees the old one
 */
static void test_contexts_set_velocity_prepares_aside_and_publishes_last(void)
{
    epf_f32_set_velocity(&ep, 1e-3f);
    const epf_f32_t before = ep;
    epf_f32_set_velocity(&ep, 5e-3f);
    TEST_ASSERT_TRUE(ep.published != before.published);
    TEST_ASSERT_EQUAL_MEMORY(&before.points[before.published], &ep.points[before.published],
                             sizeof before.points[0]);
}

static void test_contexts_estimators_share_constant_coefficients(void)
{
    epf_f32_t other;
    epf_f32_init(&other, &table_2);
    (void)epf_f32_update(&ep, 5e-6f, 1e-3f);
    TEST_ASSERT_TRUE(epf_f32_z(&other) == 0.0f);
}

static void test_footprint_is_at_most_64_bytes_per_estimator(void)
{
    TEST_ASSERT_TRUE(sizeof(epf_f32_t) <= 64);
}

/* Cores that flush subnormal numbers would take a smaller reciprocal for 0, and infinity times that is NaN */
static void test_largest_stribeck_velocity_has_a_reciprocal_on_every_core(void)
{
    epf_params_t p = parameter_sets[0].params;
    p.v_s = FLT_MAX;
    epf_f32_coeffs_t c;
    TEST_ASSERT_EQUAL_INT(EPF_OK, epf_f32_coeffs_init(&c, &p));
    TEST_ASSERT_TRUE(c.inv_v_s >= FLT_MIN);
    TEST_ASSERT_FLOAT_WITHIN(1e-6f, p.f_c, epf_f32_fss(&c, INFINITY));
}

static void run_by(epf_update_t its_rule)
{
    rule = its_rule;
    RUN_TEST(test_coeffs_macro_equals_coeffs_init_bit_for_bit);
    RUN_TEST(test_coeffs_carry_the_values_of_table_2);
    RUN_TEST(test_init_is_at_rest);
    RUN_TEST(test_step_by_hand_in_the_elastic_regime);
    RUN_TEST(test_step_has_the_bits_of_set_velocity_advance_and_force);
    RUN_TEST(test_reset_clamps_and_publishes_the_force_of_a_contact_at_rest);
    RUN_TEST(test_reset_leaves_nothing_of_the_past);
    RUN_TEST(test_reset_publishes_sigma_0_z);
    RUN_TEST(test_reset_forgets_the_direction_of_the_last_displacement);
    RUN_TEST(test_standstill_viscous_term_has_the_sign_of_v);
    RUN_TEST(test_bad_displacement_nan_changes_nothing_and_is_counted);
    RUN_TEST(test_bad_displacement_infinity_saturates);
    RUN_TEST(test_leap_over_a_subnormal_gap_arrives);
    RUN_TEST(test_leap_of_any_length_over_a_subnormal_gap_arrives);
    RUN_TEST(test_force_damping_may_overflow_before_it_is_divided);
    RUN_TEST(test_force_is_odd_next_to_overflow);
    RUN_TEST(test_force_guard_holds_where_damping_overflows);
    RUN_TEST(test_force_opposes_the_motion_where_all_other_terms_are_0);
    RUN_TEST(test_bad_velocity_nan_keeps_the_last_one_and_is_counted);
    RUN_TEST(test_bad_velocity_infinity_is_the_high_speed_limit);
    RUN_TEST(test_bad_time_removes_the_damping_term_and_is_counted);
    RUN_TEST(test_bad_input_force_saturates_and_stays_finite);
    RUN_TEST(test_bad_input_any_bits_leave_the_estimator_intact);
    RUN_TEST(test_range_contacts_of_any_size_move_alike);
    RUN_TEST(test_coeffs_z_max_is_the_sum_that_z_ss_is_and_not_above);
    RUN_TEST(test_flush_to_zero_promises_hold_for_any_bits);
    RUN_TEST(test_flush_to_zero_subnormal_time_is_usable_or_counted);
    RUN_TEST(test_rejected_never_wraps);
    RUN_TEST(test_contexts_set_velocity_prepares_aside_and_publishes_last);
    RUN_TEST(test_contexts_estimators_share_constant_coefficients);
    RUN_TEST(test_footprint_is_at_most_64_bytes_per_estimator);
    RUN_TEST(test_largest_stribeck_velocity_has_a_reciprocal_on_every_core);
}

int main(void)
{
    UNITY_BEGIN();
    run_by(EPF_UPDATE_SATURATED);
    RUN_TEST(test_step_by_hand_through_case_1_is_guarded);
    run_by(EPF_UPDATE_MEAN_VALUE);
    RUN_TEST(test_step_by_hand_through_case_1_lets_go_in_part);
    RUN_TEST(test_advance_by_hand_with_the_mean_value_rule);
    return UNITY_END() != 0;
}
