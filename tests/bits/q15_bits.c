/* SPDX-License-Identifier: MIT */
/* Every bit that the q15 estimator returns, over one long sequence, is the same on every target. */
#include "checksums.h"
#include "contacts.h"
#include "epf/q15.h"
#include "fixed_bits.h"

static const fixed_contact_t contacts[] = {
    {{TABLE_1}, {TABLE_1_LSB}, EPF_Q15_COEFFS(TABLE_1, TABLE_1_LSB)},
    {{TABLE_2}, {TABLE_2_LSB}, EPF_Q15_COEFFS(TABLE_2, TABLE_2_LSB)},
    {{ROTARY}, {ROTARY_LSB}, EPF_Q15_COEFFS(ROTARY, ROTARY_LSB)},
    {{COULOMB}, {COULOMB_LSB}, EPF_Q15_COEFFS(COULOMB, COULOMB_LSB)},
};

const fixed_bits_t fixed_bits = {
    .variant = &q15_variant,
    .largest = INT16_MAX,
    .contacts = contacts,
    .count = sizeof contacts / sizeof contacts[0],
    .name = "CHECKSUM_Q15",
    .checksum = CHECKSUM_Q15,
};
