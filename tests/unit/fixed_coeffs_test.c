/* SPDX-License-Identifier: MIT */
/* Coefficients of the fixed-point variants: units, gains, refusals, and the macros against init. */
#include "epf/epf.h"
#include "parameter_sets.h"
#include "unity.h"

#include <math.h>
#include <string.h>

static epf_params_t params;
static epf_lsb_t lsb;

void setUp(void)
{
    params = parameter_sets[1].params;
    lsb = (epf_lsb_t){1e-8f, 1e-6f, 1e-4f, 1e-6f};
}

void tearDown(void)
{
}

typedef epf_status_t (*init_t)(epf_fixed_coeffs_t *, const epf_params_t *, const epf_lsb_t *);

static const init_t inits[] = {epf_q31_coeffs_init, epf_q15_coeffs_init};

static void refused_as(epf_status_t status, const char *why)
{
    for (int i = 0; i < 2; i++) {
        epf_fixed_coeffs_t coeffs, before;
        memset(&coeffs, 0x5a, sizeof coeffs);
        memcpy(&before, &coeffs, sizeof before);
        TEST_ASSERT_EQUAL_INT_MESSAGE(status, inits[i](&coeffs, &params, &lsb), why);
        TEST_ASSERT_EQUAL_MEMORY_MESSAGE(&before, &coeffs, sizeof before, why);
    }
    setUp();
}

/* ---- refusals ------------------------------------------------------------------------------- */

static void test_coeffs_null_pointers_are_refused(void)
{
    epf_fixed_coeffs_t c;
    for (int i = 0; i < 2; i++) {
        TEST_ASSERT_EQUAL_INT(EPF_ERR_NULL, inits[i](NULL, &params, &lsb));
        TEST_ASSERT_EQUAL_INT(EPF_ERR_NULL, inits[i](&c, NULL, &lsb));
        TEST_ASSERT_EQUAL_INT(EPF_ERR_NULL, inits[i](&c, &params, NULL));
    }
}

static void test_coeffs_bad_parameters_are_refused_as_in_f32(void)
{
    params.f_max = 0.5f;
    refused_as(EPF_ERR_F_MAX, "f_max");
    params.update = EPF_UPDATE_SECOND_ORDER;
    refused_as(EPF_ERR_UPDATE, "second order");
}

static void test_coeffs_unusable_weights_are_refused_each_as_its_own(void)
{
    static const float bad[] = {0.0f, -1e-6f, NAN, INFINITY, 1e-42f};
    for (int i = 0; i < 5; i++) {
        lsb.x = bad[i];
        refused_as(EPF_ERR_LSB_X, "lsb.x");
        lsb.v = bad[i];
        refused_as(EPF_ERR_LSB_V, "lsb.v");
        lsb.f = bad[i];
        refused_as(EPF_ERR_LSB_F, "lsb.f");
        lsb.t = bad[i];
        refused_as(EPF_ERR_LSB_T, "lsb.t");
    }
}

static void test_coeffs_too_coarse_and_too_fine_displacements_are_refused(void)
{
    lsb.x = params.z_ba * 1.0001f;
    refused_as(EPF_ERR_LSB_X, "z_ba below one count");
    lsb.x = params.f_max / params.sigma_0 / 1.08e9f;
    refused_as(EPF_ERR_LSB_X, "z_max beyond 2^30 counts");
    /* z_ba 5e8 counts, z_c less than one count more */
    params.f_max = params.f_c;
    params.z_ba = nextafterf(params.f_c / params.sigma_0, 0.0f);
    lsb.x = params.f_c / params.sigma_0 / 1.5f;
    epf_fixed_coeffs_t c;
    TEST_ASSERT_EQUAL_INT(EPF_OK, epf_q31_coeffs_init(&c, &params, &lsb));
    TEST_ASSERT_TRUE(c.z_ba < c.z_c);
}

static void test_coeffs_velocity_force_and_time_out_of_range_are_refused(void)
{
    lsb.v = params.v_s * 1.7e7f;
    refused_as(EPF_ERR_LSB_V, "v_s far below one count");
    lsb.v = params.v_s / 9e9f;
    refused_as(EPF_ERR_LSB_V, "v_s beyond all counts");
    params.sigma_2 = 1e12f;
    lsb.v = params.v_s;
    refused_as(EPF_ERR_LSB_V, "viscous force of a count");
    lsb.f = params.f_max * 1.001f;
    refused_as(EPF_ERR_LSB_F, "f_max below one count");
    lsb.f = params.f_max / 2.2e9f;
    refused_as(EPF_ERR_LSB_F, "f_max beyond 2^31 counts");
    params.sigma_1 = 1e20f;
    refused_as(EPF_ERR_LSB_T, "damping of a tick");
}

static void test_coeffs_q15_refuses_a_force_beyond_16_bits_that_q31_takes(void)
{
    epf_fixed_coeffs_t c;
    lsb.f = params.f_max / 32768.0f;
    TEST_ASSERT_EQUAL_INT(EPF_ERR_LSB_F, epf_q15_coeffs_init(&c, &params, &lsb));
    TEST_ASSERT_EQUAL_INT(EPF_OK, epf_q31_coeffs_init(&c, &params, &lsb));
    lsb.f = params.f_max / 32766.0f;
    TEST_ASSERT_EQUAL_INT(EPF_OK, epf_q15_coeffs_init(&c, &params, &lsb));
}

/* ---- units and gains ------------------------------------------------------------------------ */

static void test_coeffs_z_shift_is_the_largest_that_keeps_z_max_within_2_30(void)
{
    for (int i = 0; i < 62; i++) {
        const float counts = 1.5f * powf(1.37f, (float)i); /* up to 3e8 */
        epf_fixed_coeffs_t c;
        const float z_max = params.f_max / params.sigma_0;
        lsb.x = z_max / counts;
        if (params.z_ba < lsb.x) {
            continue;
        }
        TEST_ASSERT_EQUAL_INT(EPF_OK, epf_q31_coeffs_init(&c, &params, &lsb));
        TEST_ASSERT_TRUE(c.z_max < 1L << 30 && c.z_max >= (1L << 29) - 64);
        const double unit = (double)lsb.x / (double)(1L << c.z_shift);
        TEST_ASSERT_TRUE(fabs(c.z_max * unit / (double)z_max - 1.0) < 3e-7);
        TEST_ASSERT_TRUE(fabs(c.z_ba * unit / (double)params.z_ba - 1.0) < 3e-7);
        TEST_ASSERT_TRUE(c.z_ba >= (int32_t)(1L << c.z_shift));
        TEST_ASSERT_EQUAL_UINT32(1uL << c.z_shift, c.unit);
        const int64_t leap = (int64_t)c.leap * c.unit; /* in units: just 2 z_max */
        TEST_ASSERT_TRUE(leap >= 2 * (int64_t)c.z_max && leap - c.unit < 2 * (int64_t)c.z_max);
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
    epf_fixed_coeffs_t c;
    epf_q31_t ep;
    TEST_ASSERT_EQUAL_INT(EPF_OK, epf_q31_coeffs_init(&c, &params, &lsb));
    TEST_ASSERT_EQUAL_INT32((1L << 30) - 1, c.z_max);
    epf_q31_init(&ep, &c);
    TEST_ASSERT_EQUAL_INT32(c.z_max, epf_q31_update(&ep, 1000, 0));
    TEST_ASSERT_EQUAL_INT32(-c.z_max, epf_q31_update(&ep, -1000, 0));
}

static void check_gain(epf_gain_t gain, double expected, const char *name)
{
    const double value = ldexp((double)gain.mantissa, -gain.shift);
    TEST_ASSERT_TRUE_MESSAGE(fabs(value - expected) <= 5e-7 * expected, name);
    TEST_ASSERT_TRUE_MESSAGE(gain.mantissa < 1ul << 24, name);
}

static void test_coeffs_gains_are_the_ratios_that_they_stand_for(void)
{
    for (int set = 0; set < PARAMETER_SETS; set++) {
        const epf_params_t *p = &parameter_sets[set].params;
        const epf_lsb_t w = {p->z_ba / 30.0f, p->v_s / 77.0f, p->f_max / 1e4f, 3e-5f};
        epf_fixed_coeffs_t c;
        TEST_ASSERT_EQUAL_INT(EPF_OK, epf_q15_coeffs_init(&c, p, &w));
        const double unit = (double)p->sigma_0 * (double)w.x / (double)c.unit; /* sigma_0 u, N */
        check_gain(c.v_s_inverse, (double)w.v / (double)p->v_s, "v_s_inverse");
        check_gain(c.viscous, (double)p->sigma_2 * (double)w.v / (256.0 * unit), "viscous");
        check_gain(c.damping, (double)p->sigma_1 / (double)p->sigma_0 / (double)w.t, "damping");
        check_gain(c.output, unit / (double)w.f, "output");
    }
}

/* ---- the macros ----------------------------------------------------------------------------- */

#define LORENTZIAN EPF_STRIBECK_LORENTZIAN, EPF_UPDATE_SATURATED
#define TABLE_1    1e5f, 63.0f, 0.0f, 1.0f, 1.1f, 1e-5f, 0.8e-5f, LORENTZIAN
#define TABLE_2    1e5f, 1e3f, 0.4f, 1.0f, 1.5f, 1e-3f, 8e-6f, LORENTZIAN
#define ROTARY     2.3e3f, 1.7f, 0.06f, 0.35f, 0.52f, 0.02f, 9e-5f, LORENTZIAN
#define COULOMB                                                                  \
    4.124e4f, 0.0f, 0.0f, 2.358f, 2.358f, 1e-3f, 4.17e-5f, EPF_STRIBECK_COULOMB, \
        EPF_UPDATE_SATURATED
#define FINE     1e-9f, 1e-8f, 1e-4f, 1e-6f
#define ORDINARY 1e-7f, 1e-5f, 1e-3f, 1e-5f
#define COARSE   7e-6f, 1e-2f, 1e-1f, 1e-3f

static const struct {
    epf_params_t params;
    epf_lsb_t lsb;
    epf_fixed_coeffs_t q31, q15;
} cases[] = {
    {{TABLE_1}, {FINE}, EPF_Q31_COEFFS(TABLE_1, FINE), EPF_Q15_COEFFS(TABLE_1, FINE)},
    {{TABLE_1}, {COARSE}, EPF_Q31_COEFFS(TABLE_1, COARSE), EPF_Q15_COEFFS(TABLE_1, COARSE)},
    {{TABLE_2}, {ORDINARY}, EPF_Q31_COEFFS(TABLE_2, ORDINARY), EPF_Q15_COEFFS(TABLE_2, ORDINARY)},
    {{TABLE_2}, {FINE}, EPF_Q31_COEFFS(TABLE_2, FINE), EPF_Q15_COEFFS(TABLE_2, FINE)},
    {{ROTARY}, {ORDINARY}, EPF_Q31_COEFFS(ROTARY, ORDINARY), EPF_Q15_COEFFS(ROTARY, ORDINARY)},
    {{COULOMB}, {FINE}, EPF_Q31_COEFFS(COULOMB, FINE), EPF_Q15_COEFFS(COULOMB, FINE)},
};

static void check_equal_gains(epf_gain_t a, epf_gain_t b)
{
    TEST_ASSERT_EQUAL_UINT32(a.mantissa, b.mantissa);
    TEST_ASSERT_EQUAL_INT(a.shift, b.shift);
}

static void check_equal(const epf_fixed_coeffs_t *a, const epf_fixed_coeffs_t *b)
{
    TEST_ASSERT_EQUAL_INT32(a->z_max, b->z_max);
    TEST_ASSERT_EQUAL_INT32(a->z_c, b->z_c);
    TEST_ASSERT_EQUAL_INT32(a->z_ba, b->z_ba);
    TEST_ASSERT_EQUAL_UINT32(a->unit, b->unit);
    TEST_ASSERT_EQUAL_UINT32(a->leap, b->leap);
    TEST_ASSERT_EQUAL_INT(a->z_shift, b->z_shift);
    TEST_ASSERT_EQUAL_INT(a->stribeck, b->stribeck);
    check_equal_gains(a->v_s_inverse, b->v_s_inverse);
    check_equal_gains(a->viscous, b->viscous);
    check_equal_gains(a->damping, b->damping);
    check_equal_gains(a->output, b->output);
}

static void test_coeffs_macros_equal_coeffs_init(void)
{
    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        epf_fixed_coeffs_t made;
        TEST_ASSERT_EQUAL_INT(EPF_OK, epf_q31_coeffs_init(&made, &cases[i].params, &cases[i].lsb));
        check_equal(&made, &cases[i].q31);
        TEST_ASSERT_EQUAL_INT(EPF_OK, epf_q15_coeffs_init(&made, &cases[i].params, &cases[i].lsb));
        check_equal(&made, &cases[i].q15);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_coeffs_null_pointers_are_refused);
    RUN_TEST(test_coeffs_bad_parameters_are_refused_as_in_f32);
    RUN_TEST(test_coeffs_unusable_weights_are_refused_each_as_its_own);
    RUN_TEST(test_coeffs_too_coarse_and_too_fine_displacements_are_refused);
    RUN_TEST(test_coeffs_velocity_force_and_time_out_of_range_are_refused);
    RUN_TEST(test_coeffs_q15_refuses_a_force_beyond_16_bits_that_q31_takes);
    RUN_TEST(test_coeffs_z_shift_is_the_largest_that_keeps_z_max_within_2_30);
    RUN_TEST(test_coeffs_z_max_stays_below_2_30_units);
    RUN_TEST(test_coeffs_gains_are_the_ratios_that_they_stand_for);
    RUN_TEST(test_coeffs_macros_equal_coeffs_init);
    return UNITY_END() != 0;
}
