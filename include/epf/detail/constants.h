/* SPDX-License-Identifier: MIT */
/*
 * What the EPF_xxx_COEFFS macros are made of; nothing here is for users. First the conditions that
 * params.h states, then the coefficients of f32, then those of the fixed-point variants.
 */
#ifndef EPF_DETAIL_CONSTANTS_H
#define EPF_DETAIL_CONSTANTS_H

#include "epf/params.h"

#include <float.h>
#include <stdint.h>

/* ---- the conditions on the parameters ------------------------------------------------------ */

/*
 * The conditions, each written once: epf_params_check asks them at run time, the EPF_xxx_COEFFS
 * macros at compile time. They are written so that NaN fails them. Arguments are of type float.
 */
#define EPF_FINITE_(x)            ((x) >= -FLT_MAX && (x) <= FLT_MAX)
#define EPF_POSITIVE_(x)          ((x) >= FLT_MIN && (x) <= FLT_MAX)
#define EPF_NOT_NEGATIVE_(x)      ((x) >= 0.0f && (x) <= FLT_MAX)
#define EPF_F_MAX_OK_(f_c, f_max) ((f_max) >= (f_c) && (f_max) <= FLT_MAX)
#define EPF_Z_BA_OK_(z_ba, z_c)   (EPF_POSITIVE_(z_ba) && (z_ba) < (z_c))
#ifdef EPF_STRIBECK_ONLY
#define EPF_STRIBECK_OK_(stribeck) ((unsigned)(stribeck) == (unsigned)EPF_STRIBECK_ONLY)
#else
#define EPF_STRIBECK_OK_(stribeck) ((unsigned)(stribeck) <= (unsigned)EPF_STRIBECK_COULOMB)
#endif
#define EPF_UPDATE_OK_(update) ((unsigned)(update) == (unsigned)EPF_UPDATE_SATURATED)
#define EPF_RANGE_OK_(f_max, z_max, z_c, z_ba) \
    ((f_max) <= FLT_MAX / 16.0f && (z_max) <= FLT_MAX / 16.0f && (z_c) - (z_ba) >= FLT_MIN)

/*
 * 0 where the condition holds; where it does not, a division by zero, which no compiler accepts in
 * the initialiser of an object of static storage duration. The error shows the condition.
 */
#define EPF_REQUIRE_(condition) (1 / ((condition) ? 1 : 0) - 1)

/* All conditions of epf_params_check as one constant expression, 0 or an error. */
#define EPF_REQUIRE_PARAMS_(sigma_0, sigma_1, sigma_2, f_c, f_max, v_s, z_ba, stribeck, update) \
    (EPF_REQUIRE_(EPF_POSITIVE_(sigma_0)) + EPF_REQUIRE_(EPF_NOT_NEGATIVE_(sigma_1)) +          \
     EPF_REQUIRE_(EPF_NOT_NEGATIVE_(sigma_2)) + EPF_REQUIRE_(EPF_POSITIVE_(f_c)) +              \
     EPF_REQUIRE_(EPF_F_MAX_OK_(f_c, f_max)) + EPF_REQUIRE_(EPF_POSITIVE_(v_s)) +               \
     EPF_REQUIRE_(EPF_Z_BA_OK_(z_ba, (f_c) / (sigma_0))) +                                      \
     EPF_REQUIRE_(EPF_STRIBECK_OK_(stribeck)) + EPF_REQUIRE_(EPF_UPDATE_OK_(update)) +          \
     EPF_REQUIRE_(EPF_RANGE_OK_(f_max, (f_max) / (sigma_0), (f_c) / (sigma_0), z_ba)))

/* ---- coefficients of f32 ------------------------------------------------------------------- */

/* A cast that C++ does not call old-style */
#ifdef __cplusplus
#define EPF_F32_CAST_(type, x) type(x)
#else
#define EPF_F32_CAST_(type, x) ((type)(x))
#endif

/* EPF_F32_COEFFS with its arguments named; the check adds 0, or does not compile. */
#define EPF_F32_COEFFS_(sigma_0, sigma_1, sigma_2, f_c, f_max, v_s, z_ba, stribeck, update) \
    EPF_F32_CHECKED_(EPF_F32_CAST_(float, sigma_0), EPF_F32_CAST_(float, sigma_1),          \
                     EPF_F32_CAST_(float, sigma_2), EPF_F32_CAST_(float, f_c),              \
                     EPF_F32_CAST_(float, f_max), EPF_F32_CAST_(float, v_s),                \
                     EPF_F32_CAST_(float, z_ba), stribeck, update)
#define EPF_F32_CHECKED_(sigma_0, sigma_1, sigma_2, f_c, f_max, v_s, z_ba, stribeck, update)       \
    EPF_F32_DERIVE_(                                                                               \
        sigma_0, sigma_1, sigma_2, f_c, f_max, v_s, z_ba,                                          \
        EPF_F32_CAST_(epf_stribeck_t,                                                              \
                      (stribeck) + EPF_REQUIRE_PARAMS_(sigma_0, sigma_1, sigma_2, f_c, f_max, v_s, \
                                                       z_ba, stribeck, update)))

/* What both ways of making coefficients share. */
#define EPF_F32_DERIVE_(sigma_0, sigma_1, sigma_2, f_c, f_max, v_s, z_ba, stribeck)               \
    {                                                                                             \
        (sigma_0), (sigma_1), (sigma_2), (f_c), (f_max), 1.0f / (v_s), (z_ba), (f_c) / (sigma_0), \
            EPF_F32_EXCESS_((f_c) / (sigma_0), (f_max) / (sigma_0)),                              \
            (f_c) / (sigma_0) + EPF_F32_EXCESS_((f_c) / (sigma_0), (f_max) / (sigma_0)),          \
            (stribeck)                                                                            \
    }

/* z_max - z_c, rounded so that added to z_c it gives no more than z_max */
#define EPF_F32_EXCESS_(z_c, z_max) \
    (((z_max) - (z_c)) * ((z_c) + ((z_max) - (z_c)) <= (z_max) ? 1.0f : 1.0f - FLT_EPSILON / 2.0f))

/* ---- coefficients of q31 and q15 ----------------------------------------------------------- */

/*
 * From SI units to integers, as constant expressions of floats. epf_fixed_coeffs_init comes to the
 * same integers without the repetitions; a test compares the two.
 */

/* How many of the 8 powers of two from `low` on are at least x; are above x */
#define EPF_REACHED_BY_(x, low)                                                \
    (((x) <= 1.0f * (low)) + ((x) <= 2.0f * (low)) + ((x) <= 4.0f * (low)) +   \
     ((x) <= 8.0f * (low)) + ((x) <= 16.0f * (low)) + ((x) <= 32.0f * (low)) + \
     ((x) <= 64.0f * (low)) + ((x) <= 128.0f * (low)))
#define EPF_ABOVE_(x, low)                                                                       \
    (((x) < 1.0f * (low)) + ((x) < 2.0f * (low)) + ((x) < 4.0f * (low)) + ((x) < 8.0f * (low)) + \
     ((x) < 16.0f * (low)) + ((x) < 32.0f * (low)) + ((x) < 64.0f * (low)) +                     \
     ((x) < 128.0f * (low)))

/* How often z_max, in counts, can be doubled and stay within 2^30 */
#define EPF_Z_SHIFT_(z_max)                                                  \
    (EPF_REACHED_BY_(z_max, 4194304.0f) + EPF_REACHED_BY_(z_max, 16384.0f) + \
     EPF_REACHED_BY_(z_max, 64.0f) + EPF_REACHED_BY_(z_max, 0.25f))

/* How often x can be doubled and stay below 2^24, up to 56 times */
#define EPF_GAIN_SHIFT_(x)                                                   \
    (EPF_ABOVE_(x, 65536.0f) + EPF_ABOVE_(x, 256.0f) + EPF_ABOVE_(x, 1.0f) + \
     EPF_ABOVE_(x, 1.0f / 256.0f) + EPF_ABOVE_(x, 1.0f / 65536.0f) +         \
     EPF_ABOVE_(x, 1.0f / 16777216.0f) + EPF_ABOVE_(x, 1.0f / 4294967296.0f))

/* x 2^power */
#define EPF_GAIN_(x, power)                                    \
    {                                                          \
        (uint32_t)((x) * (float)(1ULL << EPF_GAIN_SHIFT_(x))), \
            (int8_t)(EPF_GAIN_SHIFT_(x) - (power))             \
    }

/* Units from counts, kept below 2^30 so that the difference of two states fits 32 bits */
#define EPF_UNITS_(counts, z_shift)                       \
    ((counts) * (float)(1L << (z_shift)) < 1073741824.0f  \
         ? (int32_t)((counts) * (float)(1L << (z_shift))) \
         : 1073741823)

/* The quantities that become integers */
#define EPF_COUNTS_(force, sigma_0, lsb_x)           ((force) / (sigma_0) / (lsb_x))
#define EPF_V_S_INVERSE_(v_s, lsb_v)                 ((lsb_v) / (v_s))
#define EPF_VISCOUS_(sigma_2, sigma_0, lsb_x, lsb_v) ((sigma_2) / (sigma_0) * ((lsb_v) / (lsb_x)))
#define EPF_DAMPING_(sigma_1, sigma_0, lsb_t)        ((sigma_1) / (sigma_0) / (lsb_t))
#define EPF_OUTPUT_(sigma_0, lsb_x, lsb_f)           ((sigma_0) / (lsb_f) * ((lsb_x) / 256.0f))

/* Their conditions, each written once, as in params.h */
#define EPF_LSB_X_OK_(lsb_x, z_max, z_c, z_ba, z_shift)                    \
    (EPF_POSITIVE_(lsb_x) && (z_max) <= 1073741824.0f && (z_ba) >= 1.0f && \
     EPF_UNITS_(z_ba, z_shift) < EPF_UNITS_(z_c, z_shift))
#define EPF_LSB_V_OK_(lsb_v, v_s_inverse, viscous)                    \
    (EPF_POSITIVE_(lsb_v) && (v_s_inverse) >= 1.0f / 8589934592.0f && \
     (v_s_inverse) < 16777216.0f && (viscous) < 16777216.0f)
#define EPF_LSB_F_OK_(lsb_f, f_max, output, largest)                                        \
    (EPF_POSITIVE_(lsb_f) && (f_max) / (lsb_f) >= 1.0f && (f_max) / (lsb_f) <= (largest) && \
     (output) < 16777216.0f)
#define EPF_LSB_T_OK_(lsb_t, damping) (EPF_POSITIVE_(lsb_t) && (damping) < 16777216.0f)

#define EPF_Q31_LARGEST_ 2147483520.0f /* the largest float that is an int32_t */
#define EPF_Q15_LARGEST_ 32767.0f

#define EPF_REQUIRE_LSB_(sigma_0, sigma_1, sigma_2, f_c, f_max, v_s, z_ba, lsb_x, lsb_v, lsb_f, \
                         lsb_t, largest)                                                        \
    (EPF_REQUIRE_(EPF_LSB_X_OK_(lsb_x, EPF_COUNTS_(f_max, sigma_0, lsb_x),                      \
                                EPF_COUNTS_(f_c, sigma_0, lsb_x), (z_ba) / (lsb_x),             \
                                EPF_Z_SHIFT_(EPF_COUNTS_(f_max, sigma_0, lsb_x)))) +            \
     EPF_REQUIRE_(EPF_LSB_V_OK_(lsb_v, EPF_V_S_INVERSE_(v_s, lsb_v),                            \
                                EPF_VISCOUS_(sigma_2, sigma_0, lsb_x, lsb_v))) +                \
     EPF_REQUIRE_(EPF_LSB_F_OK_(lsb_f, f_max, EPF_OUTPUT_(sigma_0, lsb_x, lsb_f), largest)) +   \
     EPF_REQUIRE_(EPF_LSB_T_OK_(lsb_t, EPF_DAMPING_(sigma_1, sigma_0, lsb_t))))

#define EPF_LEAP_(z_max, z_shift) (((2u * (uint32_t)(z_max)-1u) >> (z_shift)) + 1u)

#define EPF_FIXED_DERIVE_(sigma_0, sigma_1, sigma_2, f_c, f_max, v_s, z_ba, stribeck, lsb_x,      \
                          lsb_v, lsb_f, lsb_t)                                                    \
    EPF_FIXED_SHIFTED_(EPF_COUNTS_(f_max, sigma_0, lsb_x), EPF_COUNTS_(f_c, sigma_0, lsb_x),      \
                       (z_ba) / (lsb_x), EPF_V_S_INVERSE_(v_s, lsb_v),                            \
                       EPF_VISCOUS_(sigma_2, sigma_0, lsb_x, lsb_v),                              \
                       EPF_DAMPING_(sigma_1, sigma_0, lsb_t), EPF_OUTPUT_(sigma_0, lsb_x, lsb_f), \
                       stribeck, EPF_Z_SHIFT_(EPF_COUNTS_(f_max, sigma_0, lsb_x)))

/* From z_max, z_c, z_ba in counts, and gains per count */
#define EPF_FIXED_SHIFTED_(z_max, z_c, z_ba, v_s_inverse, viscous, damping, output, stribeck,  \
                           z_shift)                                                            \
    {                                                                                          \
        EPF_UNITS_(z_max, z_shift), EPF_UNITS_(z_c, z_shift), EPF_UNITS_(z_ba, z_shift),       \
            (uint32_t)1 << (z_shift), EPF_LEAP_(EPF_UNITS_(z_max, z_shift), z_shift),          \
            EPF_GAIN_(v_s_inverse, 0), EPF_GAIN_(viscous, (z_shift)-8), EPF_GAIN_(damping, 0), \
            EPF_GAIN_(output, 8 - (z_shift)), (uint8_t)(z_shift), (stribeck)                   \
    }

/* Arguments: the fields of epf_params_t, then those of epf_lsb_t, in their order */
#define EPF_FIXED_COEFFS_(largest, ...) EPF_FIXED_COEFFS_NAMED_(largest, __VA_ARGS__)
#define EPF_FIXED_COEFFS_NAMED_(largest, sigma_0, sigma_1, sigma_2, f_c, f_max, v_s, z_ba,         \
                                stribeck, update, lsb_x, lsb_v, lsb_f, lsb_t)                      \
    EPF_FIXED_DERIVE_(                                                                             \
        (float)(sigma_0), (float)(sigma_1), (float)(sigma_2), (float)(f_c), (float)(f_max),        \
        (float)(v_s), (float)(z_ba),                                                               \
        (epf_stribeck_t)((stribeck) +                                                              \
                         EPF_REQUIRE_PARAMS_((float)(sigma_0), (float)(sigma_1), (float)(sigma_2), \
                                             (float)(f_c), (float)(f_max), (float)(v_s),           \
                                             (float)(z_ba), stribeck, update) +                    \
                         EPF_REQUIRE_LSB_((float)(sigma_0), (float)(sigma_1), (float)(sigma_2),    \
                                          (float)(f_c), (float)(f_max), (float)(v_s),              \
                                          (float)(z_ba), (float)(lsb_x), (float)(lsb_v),           \
                                          (float)(lsb_f), (float)(lsb_t), largest)),               \
        (float)(lsb_x), (float)(lsb_v), (float)(lsb_f), (float)(lsb_t))

#endif
