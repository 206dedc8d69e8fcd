/* SPDX-License-Identifier: MIT */
/*
 * The contract of q31.h and q15.h beyond the theorems. Tests called test_scaling_N check sentence [N]
 * of the "Scaling and overflow" paragraphs, for both variants by both update rules.
 */
#include "fixed_walk.h"
#include "oracle.h"
#include "parameter_sets.h"
#include "unity.h"

#include <math.h>

void setUp(void)
{
}

void tearDown(void)
{
}

/* ---- a contact for each test ---------------------------------------------------------------- */

static const fixed_variant_t *variant;
static epf_params_t params;
static epf_lsb_t lsb;
static any_coeffs_t coeffs;
static fixed_lengths_t c;
static any_contact_t ep;

static void prepare(int way)
{
    variant = fixed_way_variant(way);
    params.update = fixed_way_rule(way);
    TEST_ASSERT_EQUAL_INT(EPF_OK, variant->coeffs_init(&coeffs, &params, &lsb));
    c = variant->lengths(&coeffs);
    variant->init(&ep, &coeffs);
}

/* Table II, 10 nm, 10 um/s, 0.1 mN, 10 us */
static void use_table_2(int way)
{
    params = parameter_sets[1].params;
    lsb = (epf_lsb_t){1e-8f, 1e-5f, 1e-4f, 1e-5f};
    prepare(way);
}

static bool is_q31(void)
{
    return variant == &q31_variant;
}

static int32_t most_negative(void)
{
    return -variant->signal_max - 1;
}

static int32_t largest(void)
{
    return variant->signal_max;
}

static double newtons(int32_t force)
{
    return force * (double)lsb.f;
}

/* sigma_0 u: what a unit of the internal force weighs, N */
static double unit_force(void)
{
    return (double)params.sigma_0 * (double)lsb.x / (double)(1L << c.z_shift);
}

/* ---- scaling and overflow ------------------------------------------------------------------- */

static void test_scaling_1_reset_clamps_to_z_max(void)
{
    for (int way = 0; way < FIXED_WAYS; way++) {
        use_table_2(way);
        variant->reset(&ep, INT32_MAX);
        TEST_ASSERT_EQUAL_INT32(c.z_max, variant->z(&ep));
        TEST_ASSERT_TRUE(fabs(newtons(variant->output(&ep)) - 1.5) < 1.1e-4);
        variant->reset(&ep, INT32_MIN);
        TEST_ASSERT_EQUAL_INT32(-c.z_max, variant->z(&ep));
        (void)variant->step(&ep, -largest(), 0, 1);
        variant->reset(&ep, c.z_ba);
        TEST_ASSERT_EQUAL_INT32(c.z_ba, variant->z(&ep));
        const int32_t at_rest = variant->output(&ep);
        TEST_ASSERT_EQUAL_INT32(at_rest, variant->force(&ep, 1)); /* no damping is left */
    }
}

static void test_scaling_2_and_3_steady_state_force_is_rounded_and_within_its_range(void)
{
    for (int way = 0; way < FIXED_WAYS; way++) {
        for (int set = 0; set < PARAMETER_SETS; set++) {
            params = parameter_sets[set].params;
            lsb = (epf_lsb_t){params.z_ba / 20.0f, params.v_s / 1000.0f, params.f_max / 30000.0f,
                              1e-5f};
            prepare(way);
            TEST_ASSERT_EQUAL_INT32(0, variant->fss(&coeffs, 0));
            for (int32_t v = 1; v < 32768; v += 12 + EPF_TEST_ONE_IN) {
                const double exact = oracle_fss(&params, v * (double)lsb.v);
                const int32_t f_ss = variant->fss(&coeffs, v);
                const double excess = (double)(params.f_max - params.f_c);
                const double accuracy = is_q31() ? 0.51 * (double)lsb.f + 5e-6 * excess
                                                 : 1.6 * (double)lsb.f + 1e-3 * excess;
                TEST_ASSERT_TRUE(fabs(newtons(f_ss) - exact) <= accuracy);
                TEST_ASSERT_TRUE(newtons(f_ss) <= (double)params.f_max + (double)lsb.f);
                TEST_ASSERT_TRUE(newtons(f_ss) >= (double)params.f_c - 1.6 * (double)lsb.f);
                TEST_ASSERT_EQUAL_INT32(-f_ss, variant->fss(&coeffs, -v));
            }
        }
    }
}

static void test_scaling_4_alpha_is_q30_from_0_to_1(void)
{
    static const double accuracy[] = {2e-3, 1e-5}; /* q15, q31 */
    for (int way = 0; way < FIXED_WAYS; way++) {
        use_table_2(way);
        const int32_t v = 100;
        const double z_ss = variant->fss(&coeffs, v) * (double)lsb.f / (double)params.sigma_0;
        int32_t before = 0;
        for (int32_t z = -c.z_max; z <= c.z_max - 100003; z += 100003) {
            const int32_t alpha = variant->alpha(&coeffs, z, v);
            const double metres = z * unit_force() / (double)params.sigma_0;
            const double exact = oracle_alpha(&params, metres, v * (double)lsb.v);
            TEST_ASSERT_TRUE(alpha >= before - (is_q31() ? 64 : 0) && alpha <= 1L << 30);
            TEST_ASSERT_TRUE(fabs(metres - z_ss) < 1e-9 ||
                             fabs(alpha / 1073741824.0 - exact) < accuracy[is_q31()]);
            TEST_ASSERT_TRUE(is_q31() || alpha % 16384 == 0);
            TEST_ASSERT_EQUAL_INT32(alpha, variant->alpha(&coeffs, -z, -v));
            before = alpha;
        }
        variant->set_velocity(&ep, v);
        const int32_t z_ss_of_v = variant->z_ss(&ep);
        TEST_ASSERT_EQUAL_INT32(1L << 30, variant->alpha(&coeffs, INT32_MAX, v));
        TEST_ASSERT_EQUAL_INT32(1L << 30, variant->alpha(&coeffs, z_ss_of_v, v));
        TEST_ASSERT_TRUE(variant->alpha(&coeffs, z_ss_of_v - 1, v) < 1L << 30);
        TEST_ASSERT_EQUAL_INT32(0, variant->alpha(&coeffs, c.z_ba, v));
        TEST_ASSERT_EQUAL_INT32(0, variant->alpha(&coeffs, INT32_MIN, v));
        TEST_ASSERT_EQUAL_INT32(0, variant->alpha(&coeffs, c.z_max, 0));
        TEST_ASSERT_EQUAL_INT32(0, variant->alpha(&coeffs, 0, v));
    }
}

static void test_scaling_5_all_velocities_are_allowed(void)
{
    for (int way = 0; way < FIXED_WAYS; way++) {
        use_table_2(way);
        variant->set_velocity(&ep, most_negative());
        const int32_t z_ss = variant->z_ss(&ep), viscous = variant->viscous(&ep);
        variant->set_velocity(&ep, -largest());
        TEST_ASSERT_TRUE(z_ss <= variant->z_ss(&ep) && z_ss >= c.z_c);
        TEST_ASSERT_TRUE(viscous <= variant->viscous(&ep) && viscous < 0);
    }
}

/* What is left of f_max - f_c at the largest speed, for weights up to that of which one is v_s */
static void test_scaling_6_speed_saturates_where_the_stribeck_effect_has_vanished(void)
{
    static const float saturation[] = {60.0f, 512.0f}; /* q15, q31 */
    static const double most_left[] = {1.0 / 900.0, 1.0 / (512.0 * 512.0)};
    for (int way = 0; way < FIXED_WAYS; way++) {
        use_table_2(way);
        const float finest = saturation[is_q31()] * params.v_s / (float)largest();
        for (int k = 0; finest * powf(1.37f, (float)k) < 2.0f * params.v_s; k++) {
            lsb.v = finest * powf(1.37f, (float)k);
            prepare(way);
            variant->set_velocity(&ep, largest());
            const double left = (variant->z_ss(&ep) - c.z_c) / (double)(c.z_max - c.z_c);
            TEST_ASSERT_TRUE(left >= 0.0 && left <= most_left[is_q31()]);
        }
    }
}

static void test_scaling_7_viscous_term_is_rounded_towards_zero_and_saturates(void)
{
    for (int way = 0; way < FIXED_WAYS; way++) {
        use_table_2(way);
        for (int32_t v = -30000; v <= 30000; v += 997) {
            variant->set_velocity(&ep, v);
            const double exact =
                (double)params.sigma_2 * v * (double)lsb.v / (256.0 * unit_force());
            const double rounded = variant->viscous(&ep);
            TEST_ASSERT_TRUE(fabs(rounded) <= fabs(exact) * (1.0 + 1e-6));
            TEST_ASSERT_TRUE(fabs(rounded - exact) < 1.0 + fabs(exact) * (is_q31() ? 1e-6 : 4e-5));
        }
        params.sigma_2 = 1e6f;
        prepare(way);
        variant->set_velocity(&ep, largest());
        const int32_t most = variant->viscous(&ep);
        TEST_ASSERT_TRUE(most > 1L << 27 && most <= 1L << 28 && 256.0 * most > 32.0 * c.z_max);
        variant->set_velocity(&ep, -largest());
        TEST_ASSERT_EQUAL_INT32(-most, variant->viscous(&ep));
    }
}

static void test_scaling_8_displacement_enters_the_state_by_a_shift(void)
{
    for (int way = 0; way < FIXED_WAYS; way++) {
        use_table_2(way);
        for (int32_t dx = -800; dx <= 800; dx += 7) { /* z_ba is 800 counts */
            variant->reset(&ep, 0);
            TEST_ASSERT_EQUAL_INT32(dx * (1L << c.z_shift), variant->advance(&ep, dx));
        }
    }
}

static void test_scaling_9_all_displacements_are_allowed(void)
{
    for (int way = 0; way < FIXED_WAYS; way++) {
        use_table_2(way);
        TEST_ASSERT_EQUAL_INT32(-c.z_max, variant->advance(&ep, most_negative()));
        TEST_ASSERT_EQUAL_INT32(c.z_max, variant->advance(&ep, largest()));
        TEST_ASSERT_EQUAL_INT32(-c.z_max, variant->advance(&ep, -3000)); /* 2 z_max */
        TEST_ASSERT_TRUE(variant->advance(&ep, 2998) < c.z_max);
        variant->set_velocity(&ep, -300);
        const int32_t z_ss = variant->z_ss(&ep);
        for (int32_t z = -8; z <= 8; z++) { /* from below z_ss and from above */
            variant->reset(&ep, c.z_max / 8 * z);
            TEST_ASSERT_EQUAL_INT32(z_ss, variant->advance(&ep, 3000));
            variant->reset(&ep, c.z_max / 8 * z);
            TEST_ASSERT_EQUAL_INT32(-z_ss, variant->advance(&ep, most_negative()));
        }
    }
}

static void state_is_in_range(const fixed_step_t *step)
{
    fixed_check(step, step->z >= -step->lengths.z_max && step->z <= step->lengths.z_max, "range");
}

static void test_scaling_10_state_stays_in_its_range(void)
{
    fixed_walk(500, state_is_in_range);
}

static void test_scaling_11_damping_term_is_rounded_towards_zero_and_saturates(void)
{
    static const double accuracy[] = {1.0 / 8192.0, 1.0 / 16384.0}; /* q15, q31 */
    for (int way = 0; way < FIXED_WAYS; way++) {
        use_table_2(way);
        for (uint32_t dt = 1; dt < (is_q31() ? 3900000000u : 65536u); dt += 1 + dt / 9) {
            for (int32_t dx = 1; dx <= 700; dx += 23) {
                variant->reset(&ep, 0);
                const int64_t z = variant->advance(&ep, dx);
                const double rest = (double)(variant->internal_force(&ep, dt) - z) / 256.0;
                const double exact = (double)params.sigma_1 / (double)params.sigma_0 /
                                     (dt * (double)lsb.t) * (double)z / 256.0;
                const double saturated = fmin(exact, 536870912.0);
                TEST_ASSERT_TRUE(rest <= saturated * (1.0 + accuracy[is_q31()]));
                TEST_ASSERT_TRUE(rest >= saturated * (1.0 - accuracy[is_q31()]) - 1.0);
            }
        }
    }
}

static void output_is_the_rounded_force(const fixed_step_t *step)
{
    const double unit = (double)step->params->sigma_0 * (double)step->lsb->x /
                        (double)(1L << step->lengths.z_shift);
    const double exact = (double)step->internal_force * unit / (double)step->lsb->f;
    const double largest_force = step->variant->signal_max;
    if (fabs(exact) < largest_force) {
        const bool q31 = step->variant == &q31_variant;
        const double tolerance = q31 ? 0.5 + 4e-7 * fabs(exact) : 1.6;
        fixed_check(step, fabs((double)step->force - exact) <= tolerance, "rounding of the force");
    } else {
        const double sign = exact < 0.0 ? -1.0 : 1.0;
        fixed_check(step,
                    fabs((double)step->force - sign * largest_force) <= 1e-6 * largest_force + 1.6,
                    "saturation");
    }
    fixed_check(step, (double)step->force * exact >= 0.0, "sign of the force");
    fixed_check(step, (double)step->force >= -largest_force,
                "the most negative number is not used");
}

static void test_scaling_12_13_and_14_force_is_rounded_once_saturates_and_keeps_its_sign(void)
{
    fixed_walk(1000, output_is_the_rounded_force);
}

/* Powers of two throughout, so that lsb.f is exactly sigma_0 lsb.x, or half of it: the rounded force
   is an integer multiple of the internal one */
static void rounded_force_is_passive(const fixed_step_t *step)
{
    if (step->s == 0) {
        return;
    }
    const int shift = step->lengths.z_shift - (step->variant == &q15_variant);
    int64_t f = step->s * ((int64_t)step->force * ((int64_t)1 << shift));
    const int64_t most = (int64_t)1 << 30;
    f = f > most ? most : f; /* more only adds */
    fixed_check(step, f >= -most, "no force below -2^30 in this contact");
    const int64_t z_max = step->lengths.z_max;
    const int64_t d = step->d < 2 * z_max ? step->d : 2 * z_max;
    fixed_check(step,
                2 * f * d > (step->zeta - step->zeta_before) * (step->zeta + step->zeta_before),
                "Theorem 4 for the rounded force");
}

static void test_scaling_14_theorem_4_holds_for_the_rounded_force_of_a_fine_enough_lsb(void)
{
    const epf_params_t contact = {65536.0f,
                                  0.0f,
                                  0.0f,
                                  1.0f,
                                  1.25f,
                                  1e-3f,
                                  1.0f / 131072.0f,
                                  EPF_STRIBECK_LORENTZIAN,
                                  EPF_UPDATE_SATURATED};
    for (int i = 0; i < FIXED_VARIANTS; i++) {
        const epf_lsb_t weights = {1.0f / 67108864.0f, 1e-5f,
                                   i == 0 ? 1.0f / 1024.0f : 1.0f / 2048.0f, 1e-5f};
        fixed_walk_contact(fixed_variants[i], "powers of two", &contact, &weights, 20000,
                           rounded_force_is_passive);
    }
}

/* ---- the rest of the contract --------------------------------------------------------------- */

static void test_init_is_at_rest(void)
{
    for (int way = 0; way < FIXED_WAYS; way++) {
        use_table_2(way);
        TEST_ASSERT_EQUAL_INT32(0, variant->z(&ep));
        TEST_ASSERT_EQUAL_INT32(0, variant->output(&ep));
        TEST_ASSERT_EQUAL_INT32(0, variant->force(&ep, 100));
        TEST_ASSERT_EQUAL_INT(0, *variant->rejected(&ep));
    }
}

/* After reset no motion is left: v' is v, whatever the direction was */
static void test_reset_forgets_the_direction_of_the_last_motion(void)
{
    for (int way = 0; way < FIXED_WAYS; way++) {
        use_table_2(way);
        params.sigma_2 = 100.0f;
        prepare(way);
        (void)variant->step(&ep, 100, -200, 100);
        variant->reset(&ep, 0);
        TEST_ASSERT_TRUE(fabs(newtons(variant->force(&ep, 100)) + 0.2) < 2e-4);
        TEST_ASSERT_TRUE(fabs(newtons(variant->step(&ep, 0, -200, 100)) + 0.2) < 2e-4);
    }
}

/* To the unit of z, wherever one unit makes a difference to the rounded force */
static void test_reset_publishes_the_force_of_its_state_and_no_other(void)
{
    for (int way = 0; way < FIXED_WAYS; way++) {
        use_table_2(way);
        for (int32_t z = -70000; z <= 70000; z += EPF_TEST_ONE_IN) {
            variant->reset(&ep, z);
            TEST_ASSERT_EQUAL_INT32(variant->in_lsb(&coeffs, z, 0), variant->output(&ep));
        }
    }
}

/* By hand, Table II, 400 counts of 10 nm in 1 ms at 2 mm/s: 0.4 N + 4 N + 0.0008 N, to 0.1 mN */
static void test_step_by_hand_in_the_elastic_regime(void)
{
    for (int way = 0; way < FIXED_WAYS; way++) {
        use_table_2(way);
        lsb.f = is_q31() ? 1e-4f : 2e-4f;
        prepare(way);
        TEST_ASSERT_TRUE(fabs(newtons(variant->step(&ep, 400, 200, 100)) - 4.4008) < 6e-4);
        TEST_ASSERT_TRUE(fabs(newtons(variant->output(&ep)) - 4.4008) < 6e-4);
        TEST_ASSERT_TRUE(fabs(newtons(variant->step(&ep, -300, 200, 100)) + 2.9008) < 6e-4);
    }
}

/* By hand: sliding at v_s, 1.25 N; then 3 v_s over 1 um, where z_ss falls to 1.05e-5 m and sigma_0 z to
   1.05 N, at once by the paper's rule, by the other as far as the continuous model does. At 10 ms the
   damping term is what that gives, at 10 us it is limited to 1 - 2^-10 of the others. */
static void test_step_by_hand_through_case_1_is_guarded(void)
{
    for (int way = 0; way < FIXED_WAYS; way++) {
        use_table_2(way);
        const double accuracy = is_q31() ? 2e-4 : 1e-3;
        const double left = params.update == EPF_UPDATE_SATURATED ? 0.0 : 0.2 * exp(-1.0 / 10.5);
        const double others = 1.05 + left + 0.0012;
        (void)variant->step(&ep, 4000, 100, 100);
        TEST_ASSERT_TRUE(fabs(variant->z(&ep) * unit_force() - 1.25) < accuracy);
        TEST_ASSERT_TRUE(fabs(newtons(variant->step(&ep, 100, 300, 1)) - others / 1024.0) < 2e-4);
        use_table_2(way);
        (void)variant->step(&ep, 4000, 100, 1000);
        TEST_ASSERT_TRUE(
            fabs(newtons(variant->step(&ep, 100, 300, 1000)) - (others - (0.2 - left))) < accuracy);
    }
}

static void test_bad_time_removes_the_damping_term_and_is_counted(void)
{
    for (int way = 0; way < FIXED_WAYS; way++) {
        use_table_2(way);
        variant->set_velocity(&ep, 200);
        (void)variant->advance(&ep, 400);
        TEST_ASSERT_TRUE(fabs(newtons(variant->force(&ep, 0)) - 0.4008) < 2e-4);
        TEST_ASSERT_EQUAL_INT(1, *variant->rejected(&ep));
        TEST_ASSERT_TRUE(variant->force(&ep, 1) >= variant->force(&ep, 2)); /* any other is good */
        TEST_ASSERT_EQUAL_INT(1, *variant->rejected(&ep));
        *variant->rejected(&ep) = UINT16_MAX;
        (void)variant->force(&ep, 0);
        TEST_ASSERT_EQUAL_INT(UINT16_MAX, *variant->rejected(&ep));
    }
}

/* v' = v while nothing moves, and |v| in the direction of dx when it does */
static void test_viscous_term_follows_the_displacement(void)
{
    for (int way = 0; way < FIXED_WAYS; way++) {
        use_table_2(way);
        params.sigma_1 = 0.0f;
        params.sigma_2 = 100.0f;
        prepare(way);
        TEST_ASSERT_TRUE(fabs(newtons(variant->step(&ep, 0, -200, 100)) + 0.2) < 2e-4);
        TEST_ASSERT_TRUE(fabs(newtons(variant->step(&ep, 100, -200, 100)) - 0.3) < 2e-4);
    }
}

/* Whoever is reading the operating point before the last one must not see it change */
static void test_contexts_set_velocity_prepares_aside_and_publishes_last(void)
{
    for (int way = 0; way < FIXED_WAYS; way++) {
        use_table_2(way);
        variant->set_velocity(&ep, 100);
        const any_contact_t before = ep;
        const int published = variant->published(&ep);
        variant->set_velocity(&ep, 500);
        TEST_ASSERT_EQUAL_INT(1 - published, variant->published(&ep));
        TEST_ASSERT_TRUE(variant->same_point(&before, &ep, published));
        TEST_ASSERT_TRUE(!variant->same_point(&before, &ep, 1 - published));
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_scaling_1_reset_clamps_to_z_max);
    RUN_TEST(test_scaling_2_and_3_steady_state_force_is_rounded_and_within_its_range);
    RUN_TEST(test_scaling_4_alpha_is_q30_from_0_to_1);
    RUN_TEST(test_scaling_5_all_velocities_are_allowed);
    RUN_TEST(test_scaling_6_speed_saturates_where_the_stribeck_effect_has_vanished);
    RUN_TEST(test_scaling_7_viscous_term_is_rounded_towards_zero_and_saturates);
    RUN_TEST(test_scaling_8_displacement_enters_the_state_by_a_shift);
    RUN_TEST(test_scaling_9_all_displacements_are_allowed);
    RUN_TEST(test_scaling_10_state_stays_in_its_range);
    RUN_TEST(test_scaling_11_damping_term_is_rounded_towards_zero_and_saturates);
    RUN_TEST(test_scaling_12_13_and_14_force_is_rounded_once_saturates_and_keeps_its_sign);
    RUN_TEST(test_scaling_14_theorem_4_holds_for_the_rounded_force_of_a_fine_enough_lsb);
    RUN_TEST(test_init_is_at_rest);
    RUN_TEST(test_reset_forgets_the_direction_of_the_last_motion);
    RUN_TEST(test_reset_publishes_the_force_of_its_state_and_no_other);
    RUN_TEST(test_step_by_hand_in_the_elastic_regime);
    RUN_TEST(test_step_by_hand_through_case_1_is_guarded);
    RUN_TEST(test_bad_time_removes_the_damping_term_and_is_counted);
    RUN_TEST(test_viscous_term_follows_the_displacement);
    RUN_TEST(test_contexts_set_velocity_prepares_aside_and_publishes_last);
    return UNITY_END() != 0;
}
