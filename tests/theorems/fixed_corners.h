/* SPDX-License-Identifier: MIT */
/*
 * Contacts at the corners of what the fixed-point variants accept: z_ba next to z_c and far below it,
 * f_max next to f_c and far above it, every form of f_ss, every z_shift.
 */
#ifndef EPF_TESTS_FIXED_CORNERS_H
#define EPF_TESTS_FIXED_CORNERS_H

#include "epf/params.h"

#include <stdbool.h>

typedef struct {
    epf_params_t params;
    epf_lsb_t lsb; /* of x, v and t; that of f is for 16 bits */
    int z_shift;   /* that it leads to */
} fixed_corner_t;

enum { FIXED_CORNERS = 8 * 8 * 3 * 30 };

/* False where z_ba would be below one count of displacement, or be z_c in u */
bool fixed_corner(int i, fixed_corner_t *corner);

#endif
