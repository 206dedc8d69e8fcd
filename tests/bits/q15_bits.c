/* SPDX-License-Identifier: MIT */
/* Every bit that the q15 estimator returns, over one long sequence, is the same on every target. */
#include "checksum.h"
#include "checksums.h"
#include "contacts.h"
#include "fixed_bits.h"

static const fixed_contact_t contacts[] = {
    {{TABLE_1}, {TABLE_1_LSB}, {.q15 = EPF_Q15_COEFFS(TABLE_1, TABLE_1_LSB)}},
    {{TABLE_2}, {TABLE_2_LSB}, {.q15 = EPF_Q15_COEFFS(TABLE_2, TABLE_2_LSB)}},
    {{ROTARY}, {ROTARY_LSB}, {.q15 = EPF_Q15_COEFFS(ROTARY, ROTARY_LSB)}},
    {{COULOMB}, {COULOMB_LSB}, {.q15 = EPF_Q15_COEFFS(COULOMB, COULOMB_LSB)}},
};

static uint32_t add_gains(uint32_t checksum, const any_coeffs_t *c)
{
    checksum = checksum_add(checksum, c->q15.ratio);
    checksum = checksum_add(checksum, c->q15.ratio_limit);
    checksum = checksum_add(checksum, c->q15.viscous);
    checksum = checksum_add(checksum, c->q15.viscous_limit);
    checksum = checksum_add(checksum, c->q15.viscous_shift);
    checksum = checksum_add(checksum, c->q15.damping);
    checksum = checksum_add_signed(checksum, c->q15.damping_shift);
    checksum = checksum_add(checksum, c->q15.output);
    return checksum_add(checksum, c->q15.output_shift);
}

const fixed_bits_t fixed_bits = {
    .variant = &q15_variant,
    .largest = INT16_MAX,
    .contacts = contacts,
    .count = sizeof contacts / sizeof contacts[0],
    .names = {"CHECKSUM_Q15", "CHECKSUM_Q15_MEAN_VALUE"},
    .checksums = {CHECKSUM_Q15, CHECKSUM_Q15_MEAN_VALUE},
    .add_gains = add_gains,
};
