/* SPDX-License-Identifier: MIT */
#include "fixed_corners.h"

#include <math.h>
#include <stdint.h>

/* z_ba/z_c; the last is next to 1 */
static const float elastic_shares[] = {1e-9f,  0.01f,  0.5f,    0.9f,
                                       0.985f, 0.999f, 0.9999f, 0.999999f};
/* f_max/f_c */
static const float excesses[] = {1.0f, 1.0000001f, 1.001f, 1.1f, 2.0f, 10.0f, 1e3f, 1e6f};

enum { SHARES = 8, EXCESSES = 8, FORMS = 3, Z_SHIFT_LARGEST = 29 };

static float power_of_two(int n)
{
    return (float)((int32_t)1 << n);
}

bool fixed_corner(int i, fixed_corner_t *corner)
{
    static const float f_c = 0.7f, sigma_0 = 3e4f, v_s = 2e-3f;
    const float z_c = f_c / sigma_0;
    const float f_max = f_c * excesses[i / SHARES % EXCESSES];
    const float z_max = f_max / sigma_0;
    const int form = i / (SHARES * EXCESSES) % FORMS;
    const int z_shift = i / (SHARES * EXCESSES * FORMS);
    const float lsb_x = z_max / (1.9f * power_of_two(Z_SHIFT_LARGEST - z_shift));
    const float z_ba = fmaxf(elastic_shares[i % SHARES] * z_c, lsb_x);
    *corner = (fixed_corner_t){
        {sigma_0, 100.0f, 2.0f, f_c, f_max, v_s, z_ba, (epf_stribeck_t)form, EPF_UPDATE_SATURATED},
        {lsb_x, v_s / 100.0f, f_max / 2e4f, 1e-4f},
        z_shift};
    const float unit = lsb_x / power_of_two(z_shift);
    return z_ba < z_c && floorf(z_ba / unit) < floorf(z_c / unit);
}
