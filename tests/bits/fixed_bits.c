/* SPDX-License-Identifier: MIT */
#include "fixed_bits.h"

#include "checksum.h"
#include "integers.h"
#include "unity.h"

#include <stdio.h>

enum { SAMPLES = 2048 };

/* ---- inputs --------------------------------------------------------------------------------- */

/* From 0 to 4 x, small ones as often as large ones; one in 16 is 0 or the largest */
static int32_t near_or_extreme(uint32_t *random, int32_t x, int32_t largest)
{
    switch (random_below(random, 32)) {
    case 0:
        return largest;
    case 1:
        return 0;
    default: {
        const uint32_t smaller = random_below(random, 13);
        const uint32_t near = random_below(random, 4u * (uint32_t)x) >> smaller;
        return near < (uint32_t)largest ? (int32_t)near : largest;
    }
    }
}

/* The most negative number has no positive counterpart, and must be seen too */
static int32_t signed_signal(uint32_t *random, int direction, int32_t x, int32_t largest)
{
    const int32_t magnitude = near_or_extreme(random, x, largest);
    return direction > 0 ? magnitude : magnitude == largest ? -largest - 1 : -magnitude;
}

/* ---- outputs -------------------------------------------------------------------------------- */

static uint32_t add_coeffs(uint32_t checksum, const any_coeffs_t *coeffs)
{
    const fixed_lengths_t c = fixed_bits.variant->lengths(coeffs);
    checksum = checksum_add_signed(checksum, c.z_max);
    checksum = checksum_add_signed(checksum, c.z_c);
    checksum = checksum_add_signed(checksum, c.z_ba);
    checksum = checksum_add(checksum, c.unit);
    checksum = checksum_add(checksum, c.leap);
    checksum = checksum_add_signed(checksum, c.z_shift);
    return fixed_bits.add_gains(checksum, coeffs);
}

/* The whole step at once, or in the parts that an interrupt and a loop would call */
static int32_t move(any_contact_t *ep, unsigned i, int32_t dx, int32_t v, uint32_t dt)
{
    const fixed_variant_t *variant = fixed_bits.variant;
    if (i % 2 == 0) {
        return variant->step(ep, dx, v, dt);
    }
    variant->set_velocity(ep, v);
    (void)variant->advance(ep, dx);
    return variant->force(ep, dt);
}

static uint32_t add_sample(uint32_t checksum, const any_coeffs_t *coeffs, any_contact_t *ep,
                           unsigned i, uint32_t *random)
{
    enum { SPEED = 500, TICKS = 200 };
    const fixed_variant_t *variant = fixed_bits.variant;
    const fixed_lengths_t c = variant->lengths(coeffs);
    const int32_t largest = fixed_bits.largest;
    const int direction = random_direction(random, i);
    const int32_t dx = signed_signal(random, direction, c.z_max >> c.z_shift, largest);
    const int32_t v = signed_signal(random, direction, SPEED, largest);
    const uint32_t dt = (uint32_t)near_or_extreme(random, TICKS, largest) * (1u + i % 2u);
    if (i % 256 == 255) {
        variant->reset(ep, dx);
    }
    checksum = checksum_add_signed(checksum, move(ep, i, dx, v, dt));
    checksum = checksum_add_signed(checksum, variant->output(ep));
    checksum = checksum_add_signed(checksum, variant->z(ep));
    checksum = checksum_add_signed(checksum, variant->fss(coeffs, v));
    checksum = checksum_add_signed(checksum, variant->alpha(coeffs, variant->z(ep), v));
    return checksum_add(checksum, *variant->rejected(ep));
}

/* ---- the tests ------------------------------------------------------------------------------ */

void setUp(void)
{
}

void tearDown(void)
{
}

static void test_coeffs_made_at_run_time_have_the_bits_of_the_macro(void)
{
    for (int i = 0; i < fixed_bits.count; i++) {
        const fixed_contact_t *contact = &fixed_bits.contacts[i];
        any_coeffs_t made;
        TEST_ASSERT_EQUAL_INT(
            EPF_OK, fixed_bits.variant->coeffs_init(&made, &contact->params, &contact->lsb));
        TEST_ASSERT_TRUE(fixed_bits.variant->same_coeffs(&contact->coeffs, &made));
    }
}

/* With coefficients made at run time: the macro's but for the rule, as the test above has it */
static void check_outputs(epf_update_t rule)
{
    uint32_t checksum = CHECKSUM_OF_NOTHING;
    uint32_t random = 1;
    for (int i = 0; i < fixed_bits.count; i++) {
        const fixed_contact_t *contact = &fixed_bits.contacts[i];
        epf_params_t params = contact->params;
        params.update = rule;
        any_coeffs_t coeffs;
        any_contact_t ep;
        TEST_ASSERT_EQUAL_INT(EPF_OK,
                              fixed_bits.variant->coeffs_init(&coeffs, &params, &contact->lsb));
        fixed_bits.variant->init(&ep, &coeffs);
        checksum = add_coeffs(checksum, &coeffs);
        for (unsigned k = 0; k < SAMPLES; k++) {
            checksum = add_sample(checksum, &coeffs, &ep, k, &random);
        }
    }
    printf("#define %s 0x%08lxu\n", fixed_bits.names[rule], (unsigned long)checksum);
    TEST_ASSERT_EQUAL_HEX32(fixed_bits.checksums[rule], checksum);
}

static void test_outputs_by_the_rule_of_the_paper_have_the_bits_of_every_other_target(void)
{
    check_outputs(EPF_UPDATE_SATURATED);
}

static void test_outputs_by_the_mean_value_rule_have_the_bits_of_every_other_target(void)
{
    check_outputs(EPF_UPDATE_MEAN_VALUE);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_coeffs_made_at_run_time_have_the_bits_of_the_macro);
    RUN_TEST(test_outputs_by_the_rule_of_the_paper_have_the_bits_of_every_other_target);
    RUN_TEST(test_outputs_by_the_mean_value_rule_have_the_bits_of_every_other_target);
    return UNITY_END() != 0;
}
