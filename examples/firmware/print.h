/* SPDX-License-Identifier: MIT */
/* As much of printf as the firmware needs. */
#ifndef PRINT_H
#define PRINT_H

#include <stdint.h>

void print_text(const char *text);
void print_number(int32_t number);
void print_bits(uint32_t word);

#endif
