/* SPDX-License-Identifier: MIT */
/*
 * The EPF_xxx_COEFFS macros against coeffs_init, field by field, at the corners of what is accepted and
 * with both update rules. A macro takes a list in the source, hence the table.
 */
#include "fixed_variant.h"
#include "unity.h"

void setUp(void)
{
}

void tearDown(void)
{
}

#define LORENTZIAN EPF_STRIBECK_LORENTZIAN, EPF_UPDATE_SATURATED
#define GAUSSIAN   EPF_STRIBECK_GAUSSIAN, EPF_UPDATE_MEAN_VALUE
#define COULOMB    EPF_STRIBECK_COULOMB, EPF_UPDATE_MEAN_VALUE

/* sigma_0, sigma_1, sigma_2, f_c, f_max, v_s, z_ba */
#define TABLE_1          1e5f, 63.0f, 0.0f, 1.0f, 1.1f, 1e-5f, 0.8e-5f, LORENTZIAN
#define TABLE_2          1e5f, 1e3f, 0.4f, 1.0f, 1.5f, 1e-3f, 8e-6f, GAUSSIAN
#define ROTARY           2.3e3f, 1.7f, 0.06f, 0.35f, 0.52f, 0.02f, 9e-5f, LORENTZIAN
#define PURE_COULOMB     4.124e4f, 0.0f, 0.0f, 2.358f, 2.358f, 1e-3f, 4.17e-5f, COULOMB
#define Z_BA_NEXT_TO_Z_C 65536.0f, 9.0f, 3.0f, 1.0f, 1.0f, 1e-3f, 1.5258788e-5f, LORENTZIAN
#define Z_BA_TINY        1e6f, 10.0f, 0.0f, 3.0f, 4.0f, 1e-2f, 3e-12f, GAUSSIAN
#define F_MAX_NEXT       3e4f, 5.0f, 1.0f, 0.7f, 0.70000005f, 1e-3f, 1e-5f, LORENTZIAN
#define F_MAX_FAR        3e4f, 5.0f, 1.0f, 0.7f, 7e5f, 1e-3f, 2e-5f, GAUSSIAN
#define HUGE             1e30f, 1e20f, 1e18f, 1e25f, 3e25f, 1e10f, 9e-6f, LORENTZIAN
#define SMALL            1e-20f, 1e-25f, 1e-22f, 1e-24f, 2e-24f, 1e-12f, 8e-5f, COULOMB
#define POWERS_OF_TWO    65536.0f, 2.0f, 0.5f, 1.0f, 2.0f, 0.001953125f, 7.62939453125e-6f, GAUSSIAN
#define DAMPED           1e4f, 9.9e7f, 9.9e7f, 1.0f, 1.5f, 1e-2f, 5e-5f, LORENTZIAN

/* lsb_x, lsb_v, lsb_f, lsb_t */
#define CONTACTS(C)                                                                \
    C(TABLE_1, 1e-9f, 1e-8f, 1e-4f, 1e-6f)                                         \
    C(TABLE_1, 7e-6f, 1e-2f, 1e-1f, 1e-3f)                                         \
    C(TABLE_1, 8e-6f, 1e-4f, 1.1f, 1e-9f)                                          \
    C(TABLE_1, 1.1e-14f, 1e-7f, 5e-5f, 1e-3f)                                      \
    C(TABLE_2, 1e-7f, 1e-5f, 1e-3f, 1e-5f)                                         \
    C(TABLE_2, 1e-9f, 1e-8f, 1e-4f, 1e-6f)                                         \
    C(TABLE_2, 1.5e-8f, 1e-12f, 1e-4f, 1e-5f)                                      \
    C(TABLE_2, 1.5e-8f, 16384.0f, 1e-4f, 1e4f)                                     \
    C(TABLE_2, 2e-6f, 6e-2f, 4.6e-5f, 1.0f)                                        \
    C(TABLE_2, 2e-6f, 1.67e-5f, 4.6e-5f, 1e-8f)                                    \
    C(ROTARY, 9e-5f, 2e-4f, 2e-5f, 1e-4f)                                          \
    C(ROTARY, 1e-7f, 1e-5f, 1e-3f, 1e-5f)                                          \
    C(ROTARY, 3e-10f, 0.02f, 0.52f, 10.0f)                                         \
    C(PURE_COULOMB, 1e-9f, 1e-8f, 1e-4f, 1e-6f)                                    \
    C(PURE_COULOMB, 4e-5f, 1e-3f, 2.3f, 1e-6f)                                     \
    C(Z_BA_NEXT_TO_Z_C, 1.5258789e-8f, 1e-5f, 1e-4f, 1e-5f)                        \
    C(Z_BA_NEXT_TO_Z_C, 1.5e-5f, 1e-3f, 1e-3f, 1e-5f)                              \
    C(Z_BA_TINY, 3e-12f, 1e-4f, 1e-3f, 1e-6f)                                      \
    C(Z_BA_TINY, 1e-14f, 1e-6f, 2e-4f, 1e-6f)                                      \
    C(F_MAX_NEXT, 1e-5f, 1e-5f, 1e-4f, 1e-4f)                                      \
    C(F_MAX_NEXT, 2.2e-13f, 1e-5f, 1e-4f, 1e-4f)                                   \
    C(F_MAX_FAR, 2e-5f, 1e-5f, 1e2f, 1e-4f)                                        \
    C(F_MAX_FAR, 1e-6f, 1e-4f, 25.0f, 1e-2f)                                       \
    C(HUGE, 1e-7f, 1e8f, 1e21f, 1e-12f)                                            \
    C(HUGE, 9e-6f, 1e7f, 3e25f, 1e-4f)                                             \
    C(SMALL, 8e-5f, 1e-13f, 1e-28f, 1e-6f)                                         \
    C(SMALL, 1e-9f, 1e-15f, 1e-27f, 1e-7f)                                         \
    C(POWERS_OF_TWO, 2.384185791015625e-7f, 3.0517578125e-5f, 0.0009765625f, 1.0f) \
    C(POWERS_OF_TWO, 7.62939453125e-6f, 0.001953125f, 2.0f, 0.0009765625f)         \
    C(POWERS_OF_TWO, 2.842170943040401e-14f, 1e-9f, 0.0009765625f, 0.25f)          \
    C(DAMPED, 1e-9f, 1e-6f, 1e-4f, 6e-4f)                                          \
    C(DAMPED, 4e-5f, 6e-2f, 1e-4f, 1e3f)

typedef struct {
    epf_params_t params;
    epf_lsb_t lsb;
    epf_q31_coeffs_t q31;
    epf_q15_coeffs_t q15;
} constants_t;

#define CONSTANTS(contact, ...)            \
    {{contact},                            \
     {__VA_ARGS__},                        \
     EPF_Q31_COEFFS(contact, __VA_ARGS__), \
     EPF_Q15_COEFFS(contact, __VA_ARGS__)},

static const constants_t constants[] = {CONTACTS(CONSTANTS)};

enum { COUNT = sizeof constants / sizeof constants[0] };

static void check(const fixed_variant_t *variant, const any_coeffs_t *constant, int i)
{
    any_coeffs_t made;
    TEST_ASSERT_EQUAL_INT(EPF_OK,
                          variant->coeffs_init(&made, &constants[i].params, &constants[i].lsb));
    TEST_ASSERT_TRUE(variant->same_coeffs(&made, constant));
}

static void test_macros_equal_coeffs_init_in_every_field(void)
{
    for (int i = 0; i < COUNT; i++) {
        const any_coeffs_t q31 = {.q31 = constants[i].q31};
        const any_coeffs_t q15 = {.q15 = constants[i].q15};
        check(&q31_variant, &q31, i);
        check(&q15_variant, &q15, i);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_macros_equal_coeffs_init_in_every_field);
    return UNITY_END() != 0;
}
