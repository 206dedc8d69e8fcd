/* SPDX-License-Identifier: MIT */
#include "print.h"

#include "board.h"

void print_text(const char *text)
{
    while (*text != '\0') {
        board_put(*text++);
    }
}

void print_number(int32_t number)
{
    char digits[12]; /* of the most negative number: sign, 10 digits, NUL */
    char *first = &digits[sizeof digits - 1];
    uint32_t rest = number < 0 ? 0u - (uint32_t)number : (uint32_t)number;
    *first = '\0';
    do {
        *--first = (char)('0' + rest % 10u);
        rest /= 10u;
    } while (rest != 0);
    if (number < 0) {
        *--first = '-';
    }
    print_text(first);
}

void print_bits(uint32_t word)
{
    for (int shift = 28; shift >= 0; shift -= 4) {
        board_put("0123456789abcdef"[word >> shift & 15u]);
    }
}
