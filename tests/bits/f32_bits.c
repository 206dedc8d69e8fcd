/* SPDX-License-Identifier: MIT */
/* Every bit that the float estimator returns, over one long sequence, is the same on every target. */
#include "checksum.h"
#include "checksums.h"
#include "contacts.h"
#include "epf/f32.h"
#include "integers.h"
#include "unity.h"

#include <stdio.h>
#include <string.h>

enum { SAMPLES = 2048 };

static const struct {
    epf_params_t params;
    epf_f32_coeffs_t coeffs;
} contacts[] = {
    {{TABLE_1}, EPF_F32_COEFFS(TABLE_1)},
    {{TABLE_2}, EPF_F32_COEFFS(TABLE_2)},
    {{ROTARY}, EPF_F32_COEFFS(ROTARY)},
    {{COULOMB}, EPF_F32_COEFFS(COULOMB)},
};

enum { CONTACTS = sizeof contacts / sizeof contacts[0] };

void setUp(void)
{
}

void tearDown(void)
{
}

/* ---- inputs, made of bits ------------------------------------------------------------------- */

static float from_bits(uint32_t bits)
{
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static uint32_t exponent_of(float x)
{
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits >> 23 & 0xffu;
}

/* Any 24 bits, from 2^-12 of x to 4 times x; x is positive */
static float near(uint32_t *random, float x)
{
    const uint32_t exponent = exponent_of(x) + 1u - random_below(random, 13);
    return from_bits(exponent << 23 | random_word(random) >> 9);
}

/* Mostly that, and one in 16 times a value that only a fault of the sensor would give */
static float near_or_extreme(uint32_t *random, float x)
{
    static const uint32_t extremes[] = {
        0x00000000u, 0x00000001u, 0x00800000u, 0x3f800000u, 0x7f7fffffu, /* 0 to FLT_MAX */
        0x7f800000u, 0x7fc00000u,                                        /* infinity, NaN */
    };
    const uint32_t pick = random_below(random, 16 * 7);
    return pick < 7 ? from_bits(extremes[pick]) : near(random, x);
}

/* ---- outputs -------------------------------------------------------------------------------- */

static uint32_t add_coeffs(uint32_t checksum, const epf_f32_coeffs_t *c)
{
    const float values[] = {c->sigma_0, c->sigma_1, c->sigma_2, c->f_c,      c->f_max,
                            c->inv_v_s, c->z_ba,    c->z_c,     c->z_excess, c->z_max};
    for (size_t i = 0; i < sizeof values / sizeof values[0]; i++) {
        checksum = checksum_add_float(checksum, values[i]);
    }
    return checksum_add(checksum, (uint32_t)c->stribeck);
}

/* The whole step at once, or in the parts that an interrupt and a loop would call */
static float move(epf_f32_t *ep, unsigned i, float dx, float v, float dt)
{
    if (i % 2 == 0) {
        return epf_f32_step(ep, dx, v, dt);
    }
    epf_f32_set_velocity(ep, v);
    (void)epf_f32_advance(ep, dx);
    return epf_f32_force(ep, dt);
}

static uint32_t add_sample(uint32_t checksum, epf_f32_t *ep, unsigned i, uint32_t *random)
{
    const epf_f32_coeffs_t *c = ep->coeffs;
    const float s = (float)random_direction(random, i);
    const float dx = s * near_or_extreme(random, c->z_max);
    const float v = s * near_or_extreme(random, 1.0f / c->inv_v_s);
    const float dt = near_or_extreme(random, 1e-3f);
    if (i % 256 == 255) {
        epf_f32_reset(ep, dx);
    }
    checksum = checksum_add_float(checksum, move(ep, i, dx, v, dt));
    checksum = checksum_add_float(checksum, epf_f32_output(ep));
    checksum = checksum_add_float(checksum, epf_f32_z(ep));
    checksum = checksum_add_float(checksum, epf_f32_fss(c, v));
    checksum = checksum_add_float(checksum, epf_f32_alpha(c, epf_f32_z(ep), v));
    return checksum_add(checksum, ep->rejected);
}

/* ---- tests ---------------------------------------------------------------------------------- */

static void test_coeffs_made_at_run_time_have_the_bits_of_the_macro(void)
{
    for (int i = 0; i < CONTACTS; i++) {
        epf_f32_coeffs_t made;
        TEST_ASSERT_EQUAL_INT(EPF_OK, epf_f32_coeffs_init(&made, &contacts[i].params));
        TEST_ASSERT_EQUAL_HEX32(add_coeffs(CHECKSUM_OF_NOTHING, &contacts[i].coeffs),
                                add_coeffs(CHECKSUM_OF_NOTHING, &made));
    }
}

static uint32_t checksum_by(epf_update_t rule)
{
    uint32_t checksum = CHECKSUM_OF_NOTHING;
    uint32_t random = 1;
    for (int i = 0; i < CONTACTS; i++) {
        epf_f32_coeffs_t coeffs = contacts[i].coeffs;
        coeffs.update = rule;
        epf_f32_t ep;
        epf_f32_init(&ep, &coeffs);
        checksum = add_coeffs(checksum, ep.coeffs);
        for (unsigned k = 0; k < SAMPLES; k++) {
            checksum = add_sample(checksum, &ep, k, &random);
        }
    }
    return checksum;
}

static void test_outputs_have_the_bits_of_every_other_target(void)
{
    const uint32_t saturated = checksum_by(EPF_UPDATE_SATURATED);
    const uint32_t mean_value = checksum_by(EPF_UPDATE_MEAN_VALUE);
    printf("#define CHECKSUM_F32            0x%08lxu\n", (unsigned long)saturated);
    printf("#define CHECKSUM_F32_MEAN_VALUE 0x%08lxu\n", (unsigned long)mean_value);
    TEST_ASSERT_EQUAL_HEX32(CHECKSUM_F32, saturated);
    TEST_ASSERT_EQUAL_HEX32(CHECKSUM_F32_MEAN_VALUE, mean_value);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_coeffs_made_at_run_time_have_the_bits_of_the_macro);
    RUN_TEST(test_outputs_have_the_bits_of_every_other_target);
    return UNITY_END() != 0;
}
