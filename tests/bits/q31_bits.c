/* SPDX-License-Identifier: MIT */
/* Every bit that the q31 estimator returns, over one long sequence, is the same on every target. */
#include "checksums.h"
#include "contacts.h"
#include "epf/q31.h"
#include "fixed_bits.h"
#include "unity.h"

#include <stdio.h>

static const fixed_contact_t contacts[] = {
    {{TABLE_1}, {TABLE_1_LSB}, EPF_Q31_COEFFS(TABLE_1, TABLE_1_LSB)},
    {{TABLE_2}, {TABLE_2_LSB}, EPF_Q31_COEFFS(TABLE_2, TABLE_2_LSB)},
    {{ROTARY}, {ROTARY_LSB}, EPF_Q31_COEFFS(ROTARY, ROTARY_LSB)},
    {{COULOMB}, {COULOMB_LSB}, EPF_Q31_COEFFS(COULOMB, COULOMB_LSB)},
};

static const fixed_bits_t bits = {&q31_variant, INT32_MAX, contacts,
                                  sizeof contacts / sizeof contacts[0]};

void setUp(void)
{
}

void tearDown(void)
{
}

static void test_coeffs_made_at_run_time_have_the_bits_of_the_macro(void)
{
    fixed_bits_compare_coeffs(&bits);
}

static void test_outputs_have_the_bits_of_every_other_target(void)
{
    const uint32_t checksum = fixed_bits_checksum(&bits);
    printf("#define CHECKSUM_Q31 0x%08lxu\n", (unsigned long)checksum);
    TEST_ASSERT_EQUAL_HEX32(CHECKSUM_Q31, checksum);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_coeffs_made_at_run_time_have_the_bits_of_the_macro);
    RUN_TEST(test_outputs_have_the_bits_of_every_other_target);
    return UNITY_END() != 0;
}
