/* SPDX-License-Identifier: MIT */
/* Every bit that the q31 estimator returns, over one long sequence, is the same on every target. */
#include "checksum.h"
#include "checksums.h"
#include "contacts.h"
#include "fixed_bits.h"

static const fixed_contact_t contacts[] = {
    {{TABLE_1}, {TABLE_1_LSB}, {.q31 = EPF_Q31_COEFFS(TABLE_1, TABLE_1_LSB)}},
    {{TABLE_2}, {TABLE_2_LSB}, {.q31 = EPF_Q31_COEFFS(TABLE_2, TABLE_2_LSB)}},
    {{ROTARY}, {ROTARY_LSB}, {.q31 = EPF_Q31_COEFFS(ROTARY, ROTARY_LSB)}},
    {{COULOMB}, {COULOMB_LSB}, {.q31 = EPF_Q31_COEFFS(COULOMB, COULOMB_LSB)}},
};

static uint32_t add_gain(uint32_t checksum, epf_q31_gain_t gain)
{
    checksum = checksum_add(checksum, gain.mantissa);
    checksum = checksum_add(checksum, gain.limit);
    return checksum_add(checksum, gain.up);
}

static uint32_t add_gains(uint32_t checksum, const any_coeffs_t *c)
{
    checksum = add_gain(add_gain(checksum, c->q31.ratio), c->q31.viscous);
    checksum = checksum_add(checksum, c->q31.damping);
    checksum = checksum_add_signed(checksum, c->q31.damping_shift);
    checksum = checksum_add(checksum, c->q31.output);
    return checksum_add(checksum, c->q31.output_shift);
}

const fixed_bits_t fixed_bits = {
    .variant = &q31_variant,
    .largest = INT32_MAX,
    .contacts = contacts,
    .count = sizeof contacts / sizeof contacts[0],
    .names = {"CHECKSUM_Q31", "CHECKSUM_Q31_MEAN_VALUE"},
    .checksums = {CHECKSUM_Q31, CHECKSUM_Q31_MEAN_VALUE},
    .add_gains = add_gains,
};
