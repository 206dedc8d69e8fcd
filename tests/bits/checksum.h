/* SPDX-License-Identifier: MIT */
/* FNV-1a over 32-bit words, lowest byte first whatever the byte order of the core. */
#ifndef EPF_TESTS_CHECKSUM_H
#define EPF_TESTS_CHECKSUM_H

#include <stdint.h>

#define CHECKSUM_OF_NOTHING 2166136261u

uint32_t checksum_add(uint32_t checksum, uint32_t word);

/* The same for a negative number, and for a float as it is stored */
uint32_t checksum_add_signed(uint32_t checksum, int32_t x);
uint32_t checksum_add_float(uint32_t checksum, float x);

#endif
