/* SPDX-License-Identifier: MIT */
/* The plant of the examples against closed forms, conservation laws and calculations by hand */
#include "drive.h"
#include "encoder.h"
#include "rules.h"
#include "slide.h"
#include "trigger.h"
#include "unity.h"

#include <math.h>

void setUp(void)
{
}

void tearDown(void)
{
}

/* Tables I and II of the paper */
static const friction_t table_1 = {1e5, 63.0, 0.0, 1.0, 1.1, 1e-5, 8e-6, FRICTION_LORENTZIAN};
static const friction_t table_2 = {1e5, 1e3, 0.4, 1.0, 1.5, 1e-3, 8e-6, FRICTION_LORENTZIAN};

/* For calculations by hand: z_ss = 1/2 at any speed, z_ba = 1/4 */
static const friction_t simple = {2.0, 0.25, 0.125, 1.0, 1.0, 1.0, 0.25, FRICTION_COULOMB};

static friction_t of_form(friction_t friction, friction_form_t form)
{
    friction.form = form;
    return friction;
}

/* ---- friction --------------------------------------------------------------------------------- */

static void test_each_form_has_its_steady_force_at_the_stribeck_velocity(void)
{
    const friction_t lorentzian = of_form(table_2, FRICTION_LORENTZIAN);
    const friction_t gaussian = of_form(table_2, FRICTION_GAUSSIAN);
    const friction_t coulomb = of_form(table_2, FRICTION_COULOMB);
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 1.25, friction_f_ss(&lorentzian, 1e-3));
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 1.0 + 0.5 / exp(1.0), friction_f_ss(&gaussian, 1e-3));
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 1.0, friction_f_ss(&coulomb, 1e-3));
}

static void test_the_steady_force_is_odd_and_its_deflection_largest_at_rest(void)
{
    for (int form = FRICTION_LORENTZIAN; form <= FRICTION_COULOMB; form++) {
        const friction_t p = of_form(table_2, (friction_form_t)form);
        TEST_ASSERT_TRUE(friction_f_ss(&p, -2e-4) == -friction_f_ss(&p, 2e-4));
        TEST_ASSERT_TRUE(friction_f_ss(&p, 0.0) == 0.0);
        TEST_ASSERT_TRUE(friction_z_ss(&p, -2e-4) == friction_f_ss(&p, 2e-4) / 1e5);
        TEST_ASSERT_TRUE(friction_z_ss(&p, 0.0) == 1.5 / 1e5);
    }
}

static void test_alpha_is_a_half_period_of_a_sine(void)
{
    TEST_ASSERT_DOUBLE_WITHIN(0.0, 0.0, friction_alpha(&simple, -0.4, 0.5));
    TEST_ASSERT_DOUBLE_WITHIN(0.0, 0.0, friction_alpha(&simple, 0.25, 0.5));
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 0.25, friction_alpha(&simple, 0.25 + 0.25 / 3.0, 0.5));
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 0.5, friction_alpha(&simple, 0.375, 0.5));
    TEST_ASSERT_DOUBLE_WITHIN(0.0, 1.0, friction_alpha(&simple, 0.5, 0.5));
    TEST_ASSERT_DOUBLE_WITHIN(0.0, 1.0, friction_alpha(&simple, 0.7, 0.5));
}

/* ---- the contact at a constant speed, which an infinite mass keeps ------------------------------ */

/* Glides for so long at a constant speed, from a deflection, and says what that has become */
static double glided(contact_model_t model, const friction_t *p, double z, double v, double time)
{
    const slide_t slide = {.contact = {*p, model}, .mass = HUGE_VAL};
    const long steps = 1000 + 500 * (long)(fabs(v * time) / friction_z_max(p));
    run_t run = run_from(&slide, (slide_state_t){0.0, v, z}, (double)steps / time);
    run_advance(&run, steps);
    TEST_ASSERT_DOUBLE_WITHIN(1e-11 * fabs(v * time), v * time, run.fine.x);
    TEST_ASSERT_DOUBLE_WITHIN(1e-8 * friction_z_max(p), 0.0, run.apart.z);
    return run.fine.z;
}

static void test_distance_of_a_motion_that_is_no_number_is_none(void)
{
    const slide_t slide = {.contact = {simple, CONTACT_ELASTO_PLASTIC}, .mass = HUGE_VAL};
    run_t run = run_from(&slide, (slide_state_t){0.0, (double)NAN, 0.0}, 100.0);
    run_advance(&run, 1);
    run.coarse = run.fine = (slide_state_t){0.0, 0.0, 0.0};
    run_advance(&run, 1);
    TEST_ASSERT_TRUE(isnan(run.apart.x) && isnan(run.apart.v) && isnan(run.apart.z));
}

static void test_lugre_and_dahl_approach_their_steady_states_exponentially(void)
{
    const double v = -2e-4;
    for (int i = 1; i <= 32; i *= 2) {
        const double time = 0.01 * i;
        const double lugre = friction_z_ss(&table_2, v);
        TEST_ASSERT_DOUBLE_WITHIN(1e-15, lugre * expm1(v * time / lugre),
                                  glided(CONTACT_LUGRE, &table_2, 0.0, v, time));
        const double dahl = 1.0 / 1e5;
        TEST_ASSERT_DOUBLE_WITHIN(1e-15, dahl * expm1(v * time / dahl),
                                  glided(CONTACT_DAHL, &table_2, 0.0, v, time));
    }
}

static void test_all_models_slide_with_their_steady_force(void)
{
    const double v = 3e-4;
    for (int model = CONTACT_ELASTO_PLASTIC; model <= CONTACT_COULOMB; model++) {
        const contact_t contact = {table_2, (contact_model_t)model};
        const double z = glided(contact.model, &table_2, 0.0, v, 2.0);
        const double steady =
            model == CONTACT_DAHL || model == CONTACT_COULOMB ? 1.0 : friction_f_ss(&table_2, v);
        TEST_ASSERT_DOUBLE_WITHIN(1e-9, steady + 0.4 * v, contact_force(&contact, z, v));
    }
}

static void test_elasto_plastic_deflection_follows_the_motion_up_to_z_ba_and_returns(void)
{
    const double v = 4e-5; /* 4 um in 0.1 s, half-way to z_ba */
    const double there = glided(CONTACT_ELASTO_PLASTIC, &table_1, 0.0, v, 0.1);
    TEST_ASSERT_DOUBLE_WITHIN(1e-18, 4e-6, there);
    TEST_ASSERT_DOUBLE_WITHIN(1e-18, 0.0, glided(CONTACT_ELASTO_PLASTIC, &table_1, there, -v, 0.1));
    /* LuGre does not return */
    const double lugre = glided(CONTACT_LUGRE, &table_1, 0.0, v, 0.1);
    TEST_ASSERT_TRUE(fabs(glided(CONTACT_LUGRE, &table_1, lugre, -v, 0.1)) > 1e-6);
}

/* ---- the mass ----------------------------------------------------------------------------------- */

/* A damped oscillator as long as nothing slides: x from x = 0 at the velocity v */
static double oscillation(const friction_t *p, double mass, double v, double time)
{
    const double decay = (p->sigma_1 + p->sigma_2) / (2.0 * mass);
    const double omega = sqrt(p->sigma_0 / mass - decay * decay);
    return v / omega * exp(-decay * time) * sin(omega * time);
}

static run_t oscillated(double rate)
{
    static const slide_t slide = {
        .contact = {{1e5, 63.0, 0.4, 1.0, 1.1, 1e-5, 8e-6, FRICTION_LORENTZIAN},
                    CONTACT_ELASTO_PLASTIC},
        .mass = 1.0};
    run_t run = run_from(&slide, (slide_state_t){0.0, 2e-3, 0.0}, rate);
    run_advance(&run, lround(0.05 * rate));
    return run;
}

static void test_elastic_oscillation_is_that_of_a_spring_and_a_damper(void)
{
    const run_t run = oscillated(20000.0);
    const double expected = oscillation(&run.slide->contact.friction, 1.0, 2e-3, 0.05);
    TEST_ASSERT_DOUBLE_WITHIN(1e-13, expected, run.fine.x);
    TEST_ASSERT_TRUE(run.fine.x == run.fine.z || fabs(run.fine.x - run.fine.z) < 1e-19);
}

static void test_half_the_step_is_sixteen_times_closer_and_the_distance_bounds_the_error(void)
{
    const run_t run = oscillated(2000.0);
    const double expected = oscillation(&run.slide->contact.friction, 1.0, 2e-3, 0.05);
    const double coarse = fabs(run.coarse.x - expected);
    const double fine = fabs(run.fine.x - expected);
    TEST_ASSERT_DOUBLE_WITHIN(2.0, 16.0, coarse / fine);
    TEST_ASSERT_TRUE(fine < run.apart.x);
}

/* A tremor, break-away, a slide, a reversal: see the points */
static const drive_point_t points[] = {{0.0, 0.0}, {0.3, 0.0},  {0.4, 2.0},  {0.45, 2.0},
                                       {0.5, 0.0}, {0.6, -2.0}, {0.65, 0.0}, {0.8, 0.0}};
static const drive_sine_t sines[] = {{0.05, 0.25, 0.5, 10.0}};
static const drive_t drive = {points, sizeof points / sizeof points[0], sines, 1};

static slide_t driven(contact_model_t model)
{
    return (slide_t){{table_2, model}, 10.0, drive_force, &drive};
}

/*
 * What the force puts in is in the mass, in the spring, or gone: by plastic displacement, which is
 * never negative, by the damper and by viscous friction. The powers are integrated by the trapezoidal rule.
 */
static void test_energy_is_accounted_for(void)
{
    const slide_t slide = driven(CONTACT_ELASTO_PLASTIC);
    const friction_t *p = &table_2;
    run_t run = run_from(&slide, (slide_state_t){0.0, 0.0, 0.0}, 50000.0);
    double given = 0.0;
    double gone = 0.0;
    double before[2] = {0.0, 0.0};
    while (run_time(&run) < 0.8) {
        run_advance(&run, 1);
        const slide_state_t m = run.fine;
        const double rate = contact_rate(&slide.contact, m.z, m.v);
        const double plastic = p->sigma_0 * m.z * (m.v - rate);
        const double now[2] = {drive_force(&drive, run_time(&run)) * m.v,
                               plastic + (p->sigma_1 * rate + p->sigma_2 * m.v) * m.v};
        TEST_ASSERT_TRUE(plastic >= 0.0);
        given += 0.5 * (before[0] + now[0]) / run.rate;
        gone += 0.5 * (before[1] + now[1]) / run.rate;
        before[0] = now[0];
        before[1] = now[1];
        const double kept = 5.0 * m.v * m.v + contact_energy(&slide.contact, m.z);
        TEST_ASSERT_DOUBLE_WITHIN(1e-9, given, kept + gone);
    }
    TEST_ASSERT_TRUE(given > 1e-3); /* it has slid */
}

static void test_every_model_is_integrated_to_a_small_distance(void)
{
    for (int model = CONTACT_ELASTO_PLASTIC; model <= CONTACT_COULOMB; model++) {
        const slide_t slide = driven((contact_model_t)model);
        run_t run = run_from(&slide, (slide_state_t){0.0, 0.0, 0.0}, 50000.0);
        run_advance(&run, 40000);
        TEST_ASSERT_TRUE(run.fine.x > 1e-4);
        TEST_ASSERT_DOUBLE_WITHIN(1e-8, 0.0, run.apart.x);
    }
}

static const double pull = 0.75;

static double steady_pull(const void *context, double time)
{
    (void)time;
    return *(const double *)context;
}

static void test_coulomb_friction_stops_the_mass_and_holds_it(void)
{
    /* From 1 m/s: stops after v^2/(2 a) with m a = f_c + 3/4 N, at v/a, and stays; f_c = 1 N, m = 1 kg */
    const double back = -pull;
    const friction_t p = {1.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.5, FRICTION_COULOMB};
    const slide_t slide = {{p, CONTACT_COULOMB}, 1.0, steady_pull, &back};
    run_t run = run_from(&slide, (slide_state_t){0.0, 1.0, 0.0}, 333.0);
    run_advance(&run, 666);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 1.0 / 3.5, run.fine.x);
    TEST_ASSERT_TRUE(run.fine.v == 0.0);
    TEST_ASSERT_DOUBLE_WITHIN(0.0, back, slide_friction(&slide, &run.fine, 2.0));
}

static void test_coulomb_friction_turns_with_the_mass(void)
{
    /* From 1 m/s against 3/2 N: stops after 0.4 s at 0.2 m; then back by 1/2 m/s^2 for 0.6 s */
    const double back = -1.5;
    const friction_t p = {1.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.5, FRICTION_COULOMB};
    const slide_t slide = {{p, CONTACT_COULOMB}, 1.0, steady_pull, &back};
    run_t run = run_from(&slide, (slide_state_t){0.0, 1.0, 0.0}, 333.0);
    run_advance(&run, 333);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 0.11, run.fine.x);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, -0.3, run.fine.v);
}

static void test_coulomb_friction_lets_go_above_f_c(void)
{
    const double force = 1.5;
    const friction_t p = {1.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.5, FRICTION_COULOMB};
    const slide_t slide = {{p, CONTACT_COULOMB}, 1.0, steady_pull, &force};
    run_t run = run_from(&slide, (slide_state_t){0.0, 0.0, 0.0}, 100.0);
    run_advance(&run, 100); /* 1/2 m/s^2 for 1 s */
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 0.25, run.fine.x);
    TEST_ASSERT_DOUBLE_WITHIN(0.0, 1.0, slide_friction(&slide, &run.fine, 1.0));
}

/* ---- a controller in the loop ------------------------------------------------------------------- */

/* 1 mm to and fro, once in 6.3 s */
static double wanted(const run_t *run)
{
    return 1e-3 * sin(run_time(run));
}

/* A mass that a PID controller moves, at 1 kHz, through many a stop */
static run_t controlled(bool rejoins)
{
    enum { PERIODS_PER_SECOND = 1000, STEPS_PER_PERIOD = 5, SECONDS = 10 };
    double command = 0.0;
    double sum = 0.0;
    const slide_t slide = {{table_2, CONTACT_ELASTO_PLASTIC}, 10.0, steady_pull, &command};
    run_t run = run_from(&slide, (slide_state_t){0.0, 0.0, 0.0},
                         (double)PERIODS_PER_SECOND * STEPS_PER_PERIOD);
    for (int i = 0; i < SECONDS * PERIODS_PER_SECOND; i++) {
        const double off = wanted(&run) - run.fine.x;
        sum += off / PERIODS_PER_SECOND;
        command = 1e4 * off + 1e5 * sum - 600.0 * run.fine.v;
        if (rejoins) {
            run_rejoin(&run);
        }
        run_advance(&run, STEPS_PER_PERIOD);
    }
    return run;
}

static void test_a_run_that_rejoins_stays_together_under_a_controller(void)
{
    const run_t run = controlled(true);
    TEST_ASSERT_DOUBLE_WITHIN(1e-4, wanted(&run), run.fine.x);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 0.0, run.apart.x);
    TEST_ASSERT_TRUE(controlled(false).apart.x > 1e-3);
}

static void test_rejoining_leaves_the_fine_motion_alone(void)
{
    const run_t one = controlled(true);
    const run_t other = controlled(false);
    TEST_ASSERT_TRUE(one.fine.x == other.fine.x && one.fine.z == other.fine.z);
}

/* ---- the driving force -------------------------------------------------------------------------- */

static void test_drive_is_lines_and_sines(void)
{
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 0.5, drive_force(&drive, 0.075)); /* a quarter of a period */
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 0.0, drive_force(&drive, 0.275)); /* the sine has ended */
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 1.0, drive_force(&drive, 0.35));
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 2.0, drive_force(&drive, 0.4));
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 0.0, drive_force(&drive, 9.0));
}

/* ---- sensor and trigger ------------------------------------------------------------------------- */

static void test_encoder_rounds_to_whole_counts(void)
{
    encoder_t encoder = {.resolution = 0.25};
    TEST_ASSERT_DOUBLE_WITHIN(0.0, 0.75, encoder_read(&encoder, 0.8));
    TEST_ASSERT_DOUBLE_WITHIN(0.0, -0.75, encoder_read(&encoder, -0.8));
    encoder.resolution = 0.0;
    TEST_ASSERT_DOUBLE_WITHIN(0.0, 0.8, encoder_read(&encoder, 0.8));
}

static void test_noise_is_uniform_bounded_and_told_by_its_seed(void)
{
    encoder_t one = {.noise = 0.5, .source = {7}};
    encoder_t same = one;
    double sum = 0.0;
    double squares = 0.0;
    enum { READINGS = 100000 };
    for (int i = 0; i < READINGS; i++) {
        const double off = encoder_read(&one, 3.0) - 3.0;
        TEST_ASSERT_TRUE(off >= -0.5 && off < 0.5);
        TEST_ASSERT_TRUE(encoder_read(&same, 3.0) == off + 3.0);
        sum += off;
        squares += off * off;
    }
    TEST_ASSERT_DOUBLE_WITHIN(5e-3, 0.0, sum / READINGS);
    TEST_ASSERT_DOUBLE_WITHIN(1e-3, 1.0 / 12.0, squares / READINGS);
}

static void test_trigger_waits_for_its_distance_and_tells_the_mean_velocity(void)
{
    trigger_t trigger = {.spacing = 1.0};
    update_t update = {0.0, 0.0, 0.0};
    TEST_ASSERT_FALSE(trigger_look(&trigger, 0.75, 1.0, &update));
    TEST_ASSERT_TRUE(trigger_look(&trigger, 1.25, 2.0, &update));
    TEST_ASSERT_TRUE(update.dx == 1.25 && update.dt == 2.0 && update.v == 0.625);
    TEST_ASSERT_FALSE(trigger_look(&trigger, 0.5, 3.0, &update));
    TEST_ASSERT_TRUE(trigger_look(&trigger, 0.25, 4.0, &update)); /* just far enough, and back */
    TEST_ASSERT_TRUE(update.dx == -1.0 && update.dt == 2.0 && update.v == -0.5);
    TEST_ASSERT_FALSE(trigger_look(&trigger, 9.0, 4.0, &update)); /* no time has passed */
}

/* ---- the rules ---------------------------------------------------------------------------------- */

static void test_exact_flow_is_the_continuous_model_at_constant_speed(void)
{
    for (int form = FRICTION_LORENTZIAN; form <= FRICTION_COULOMB; form++) {
        const friction_t p = of_form(table_2, (friction_form_t)form);
        for (int i = -6; i <= 6; i++) {
            for (int k = 0; k < 7; k++) {
                const double z = 2.5e-6 * i;
                const double dx = 1e-7 * pow(3.0, k);
                const double v = 7e-4;
                const double flow = rule_exact_flow(&p, z, dx, v, 1.0);
                const double glide = glided(CONTACT_ELASTO_PLASTIC, &p, z, v, dx / v);
                TEST_ASSERT_DOUBLE_WITHIN(1e-9 * 1.5e-5, glide, flow);
                TEST_ASSERT_TRUE(rule_exact_flow(&p, -z, -dx, v, 1.0) == -flow);
            }
        }
    }
}

static void test_exact_lugre_is_the_continuous_model_at_constant_speed(void)
{
    for (int i = -5; i <= 5; i += 2) {
        const double v = 2e-4 * i;
        const double expected = glided(CONTACT_LUGRE, &table_2, 4e-6, v, 0.02);
        TEST_ASSERT_DOUBLE_WITHIN(1e-14, expected,
                                  rule_lugre_exact(&table_2, 4e-6, v * 0.02, v, 0.02));
    }
    TEST_ASSERT_DOUBLE_WITHIN(1e-20, 4e-6, rule_lugre_exact(&table_2, 4e-6, 0.0, 0.0, 1.0));
}

static void test_euler_holds_the_rate_and_leaves_the_bounds_where_the_step_is_large(void)
{
    /* z = 3/8: alpha = 1/2, zeta/z_ss = 3/4; dx = 1/8 in 1/4 s */
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 0.375 + 5.0 / 64.0,
                              rule_elasto_plastic_euler(&simple, 0.375, 0.125, 0.5, 0.25));
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 0.375 + 1.0 / 32.0,
                              rule_lugre_euler(&simple, 0.375, 0.125, 0.5, 0.25));
    double z = 0.4;
    for (int i = 0; i < 10; i++) {
        z = rule_elasto_plastic_euler(&simple, z, 2.0, 2.0, 1.0);
    }
    TEST_ASSERT_TRUE(fabs(z) > 0.5);
}

static void test_algorithm_1_as_printed_is_right_only_towards_plus_x(void)
{
    const double right = 5.0 / 64.0;
    const double lugre = 1.0 / 32.0; /* alpha = 1 */
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 0.375 + right,
                              rule_algorithm_1_as_printed(&simple, 0.375, 0.125, 0.5, 0.25));
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, -0.375 - lugre,
                              rule_algorithm_1_as_printed(&simple, -0.375, -0.125, -0.5, 0.25));
    TEST_ASSERT_DOUBLE_WITHIN(0.0, 0.5,
                              rule_algorithm_1_as_printed(&simple, 0.375, 9.0, 0.5, 0.25));
    TEST_ASSERT_DOUBLE_WITHIN(0.0, -0.5,
                              rule_algorithm_1_as_printed(&simple, -0.7, -0.125, -0.5, 0.25));
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 0.25,
                              rule_algorithm_1_as_printed(&simple, 0.375, -0.125, -0.5, 0.25));
    const double at_rest = rule_algorithm_1_as_printed(&simple, 0.1, 0.125, 0.0, 0.25);
    TEST_ASSERT_FALSE(at_rest == at_rest);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_each_form_has_its_steady_force_at_the_stribeck_velocity);
    RUN_TEST(test_the_steady_force_is_odd_and_its_deflection_largest_at_rest);
    RUN_TEST(test_alpha_is_a_half_period_of_a_sine);
    RUN_TEST(test_distance_of_a_motion_that_is_no_number_is_none);
    RUN_TEST(test_lugre_and_dahl_approach_their_steady_states_exponentially);
    RUN_TEST(test_all_models_slide_with_their_steady_force);
    RUN_TEST(test_elasto_plastic_deflection_follows_the_motion_up_to_z_ba_and_returns);
    RUN_TEST(test_elastic_oscillation_is_that_of_a_spring_and_a_damper);
    RUN_TEST(test_half_the_step_is_sixteen_times_closer_and_the_distance_bounds_the_error);
    RUN_TEST(test_energy_is_accounted_for);
    RUN_TEST(test_every_model_is_integrated_to_a_small_distance);
    RUN_TEST(test_coulomb_friction_stops_the_mass_and_holds_it);
    RUN_TEST(test_coulomb_friction_turns_with_the_mass);
    RUN_TEST(test_coulomb_friction_lets_go_above_f_c);
    RUN_TEST(test_a_run_that_rejoins_stays_together_under_a_controller);
    RUN_TEST(test_rejoining_leaves_the_fine_motion_alone);
    RUN_TEST(test_drive_is_lines_and_sines);
    RUN_TEST(test_encoder_rounds_to_whole_counts);
    RUN_TEST(test_noise_is_uniform_bounded_and_told_by_its_seed);
    RUN_TEST(test_trigger_waits_for_its_distance_and_tells_the_mean_velocity);
    RUN_TEST(test_exact_flow_is_the_continuous_model_at_constant_speed);
    RUN_TEST(test_exact_lugre_is_the_continuous_model_at_constant_speed);
    RUN_TEST(test_euler_holds_the_rate_and_leaves_the_bounds_where_the_step_is_large);
    RUN_TEST(test_algorithm_1_as_printed_is_right_only_towards_plus_x);
    return UNITY_END() != 0;
}
