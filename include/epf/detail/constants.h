/* SPDX-License-Identifier: MIT */
/*
 * What the EPF_xxx_COEFFS macros are made of; nothing here is for users. First the conditions that
 * params.h states, then the coefficients of f32, then those of the fixed-point variants.
 */
#ifndef EPF_DETAIL_CONSTANTS_H
#define EPF_DETAIL_CONSTANTS_H

#ifdef __GNUC__ /* a bad parameter is reported once, and not for every macro on the way to it */
#pragma GCC system_header
#endif

#include "epf/params.h"

#include <float.h>
#include <stdint.h>

/* A cast that C++ does not call old-fashioned */
#ifdef __cplusplus
#define EPF_CAST_(type, x) static_cast<type>(x)
#else
#define EPF_CAST_(type, x) ((type)(x))
#endif

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
#define EPF_STRIBECK_OK_(stribeck) \
    (EPF_CAST_(unsigned, stribeck) == EPF_CAST_(unsigned, EPF_STRIBECK_ONLY))
#else
#define EPF_STRIBECK_OK_(stribeck) \
    (EPF_CAST_(unsigned, stribeck) <= EPF_CAST_(unsigned, EPF_STRIBECK_COULOMB))
#endif
#ifdef EPF_UPDATE_ONLY
#define EPF_UPDATE_OK_(update) (EPF_CAST_(unsigned, update) == EPF_CAST_(unsigned, EPF_UPDATE_ONLY))
#else
#define EPF_UPDATE_OK_(update) \
    (EPF_CAST_(unsigned, update) <= EPF_CAST_(unsigned, EPF_UPDATE_MEAN_VALUE))
#endif
#define EPF_RANGE_OK_(f_max, z_max, z_c, z_ba) \
    ((f_max) <= FLT_MAX / 16.0f && (z_max) <= FLT_MAX / 16.0f && (z_c) - (z_ba) >= FLT_MIN)

/*
 * EPF_REQUIRE_(condition, cause) is 0 where the condition holds. Where it does not, the program does not
 * compile, and the first line of the message names the cause. A condition compares floats, which the
 * language does not count as an integer constant expression; compilers evaluate it all the same.
 */
#if defined(__cplusplus)
extern "C++" {
#define EPF_CAUSE_(cause)                  \
    template <bool> struct epf_##cause;    \
    template <> struct epf_##cause<true> { \
        char holds;                        \
    };
EPF_CAUSE_(sigma_0_must_be_positive)
EPF_CAUSE_(sigma_1_must_not_be_negative)
EPF_CAUSE_(sigma_2_must_not_be_negative)
EPF_CAUSE_(f_c_must_be_positive)
EPF_CAUSE_(f_max_must_be_at_least_f_c)
EPF_CAUSE_(v_s_must_be_positive)
EPF_CAUSE_(z_ba_must_be_positive_and_below_z_c)
EPF_CAUSE_(stribeck_must_be_a_form_of_this_build)
EPF_CAUSE_(update_must_be_a_rule_of_this_build)
EPF_CAUSE_(the_parameters_leave_the_range_of_float)
EPF_CAUSE_(lsb_x_must_be_at_most_z_ba_and_not_far_too_fine)
EPF_CAUSE_(lsb_v_must_be_positive_and_not_far_from_v_s)
EPF_CAUSE_(lsb_f_must_be_at_most_f_max_which_must_fit)
EPF_CAUSE_(lsb_t_must_be_positive_and_not_far_too_fine)
#undef EPF_CAUSE_
}
#define EPF_REQUIRE_(condition, cause) static_cast<int>(sizeof(epf_##cause<(condition)>) - 1u)
#elif defined(__GNUC__)
#define EPF_REQUIRE_(condition, cause) \
    (EPF_CAST_(int, 0u * __extension__ sizeof(struct { int cause : (condition) ? 1 : -1; })))
#else /* a division by zero: no initialiser of an object of static storage duration */
#define EPF_REQUIRE_(condition, cause) (1 / ((condition) ? 1 : 0) - 1)
#endif

/* All conditions of epf_params_check as one constant expression, 0 or an error */
#define EPF_REQUIRE_PARAMS_(sigma_0, sigma_1, sigma_2, f_c, f_max, v_s, z_ba, stribeck, update) \
    (EPF_REQUIRE_(EPF_POSITIVE_(sigma_0), sigma_0_must_be_positive) +                           \
     EPF_REQUIRE_(EPF_NOT_NEGATIVE_(sigma_1), sigma_1_must_not_be_negative) +                   \
     EPF_REQUIRE_(EPF_NOT_NEGATIVE_(sigma_2), sigma_2_must_not_be_negative) +                   \
     EPF_REQUIRE_(EPF_POSITIVE_(f_c), f_c_must_be_positive) +                                   \
     EPF_REQUIRE_(EPF_F_MAX_OK_(f_c, f_max), f_max_must_be_at_least_f_c) +                      \
     EPF_REQUIRE_(EPF_POSITIVE_(v_s), v_s_must_be_positive) +                                   \
     EPF_REQUIRE_(EPF_Z_BA_OK_(z_ba, (f_c) / (sigma_0)), z_ba_must_be_positive_and_below_z_c) + \
     EPF_REQUIRE_(EPF_STRIBECK_OK_(stribeck), stribeck_must_be_a_form_of_this_build) +          \
     EPF_REQUIRE_(EPF_UPDATE_OK_(update), update_must_be_a_rule_of_this_build) +                \
     EPF_REQUIRE_(EPF_RANGE_OK_(f_max, (f_max) / (sigma_0), (f_c) / (sigma_0), z_ba),           \
                  the_parameters_leave_the_range_of_float))

/* ---- coefficients of f32 ------------------------------------------------------------------- */

/* EPF_F32_COEFFS with its arguments named; the check adds 0, or does not compile. */
#define EPF_F32_COEFFS_(sigma_0, sigma_1, sigma_2, f_c, f_max, v_s, z_ba, stribeck, update)     \
    EPF_F32_CHECKED_(EPF_CAST_(float, sigma_0), EPF_CAST_(float, sigma_1),                      \
                     EPF_CAST_(float, sigma_2), EPF_CAST_(float, f_c), EPF_CAST_(float, f_max), \
                     EPF_CAST_(float, v_s), EPF_CAST_(float, z_ba), stribeck, update)
#define EPF_F32_CHECKED_(sigma_0, sigma_1, sigma_2, f_c, f_max, v_s, z_ba, stribeck, update)   \
    EPF_F32_DERIVE_(                                                                           \
        sigma_0, sigma_1, sigma_2, f_c, f_max, v_s, z_ba,                                      \
        EPF_CAST_(epf_stribeck_t,                                                              \
                  (stribeck) + EPF_REQUIRE_PARAMS_(sigma_0, sigma_1, sigma_2, f_c, f_max, v_s, \
                                                   z_ba, stribeck, update)),                   \
        update)

/* What both ways of making coefficients share. */
#define EPF_F32_DERIVE_(sigma_0, sigma_1, sigma_2, f_c, f_max, v_s, z_ba, stribeck, update) \
    {                                                                                       \
        (sigma_0), (sigma_1), (sigma_2), (f_c), (f_max), EPF_F32_INVERSE_(v_s), (z_ba),     \
            (f_c) / (sigma_0), EPF_F32_EXCESS_((f_c) / (sigma_0), (f_max) / (sigma_0)),     \
            (f_c) / (sigma_0) + EPF_F32_EXCESS_((f_c) / (sigma_0), (f_max) / (sigma_0)),    \
            (stribeck), (update)                                                            \
    }

/* 1/v_s, not so small that some cores take it for 0 */
#define EPF_F32_INVERSE_(v_s) ((v_s) <= 8.50705917e37f ? 1.0f / (v_s) : FLT_MIN)

/* z_max - z_c, rounded so that added to z_c it gives no more than z_max */
#define EPF_F32_EXCESS_(z_c, z_max) \
    (((z_max) - (z_c)) * ((z_c) + ((z_max) - (z_c)) <= (z_max) ? 1.0f : 1.0f - FLT_EPSILON / 2.0f))

/* ---- coefficients of q31 and q15 ----------------------------------------------------------- */

/*
 * From SI units to integers, as constant expressions of floats, and the same text at run time.
 *
 * Short names, because they are repeated: x is a positive float.
 */

/* floor(log2 x) for 2^-32 <= x < 2^32; -32 below. Standard C can say it too, but only in half a
   megabyte of comparisons. */
#if defined(__GNUC__)
#define EPF_EXPONENT_(x) \
    (31 - __builtin_clzll(EPF_CAST_(unsigned long long, (x)*4294967296.0f) | 1u))
#else
#define EPF_EXPONENT_(x) constant_coefficients_need_gcc_or_clang_so_call_coeffs_init
#endif

/* 2^n, 0 <= n <= 63; x 2^n, -63 <= n <= 63 */
#define EPF_POWER_(n) EPF_CAST_(float, 1ULL << (n))
#define EPF_SCALED_(x, n) \
    ((n) < 0 ? (x) / EPF_POWER_((n) < 0 ? -(n) : 0) : (x)*EPF_POWER_((n) < 0 ? 0 : (n)))

/* The float below 2^n */
#define EPF_BELOW_POWER_(n) (EPF_POWER_(n) * 0.99999994f)

/* The largest n with z_max 2^n <= 2^30, z_max in counts; the factor takes powers of two one down */
#define EPF_Z_SHIFT_(z_max) (29 - EPF_EXPONENT_((z_max)*0.99999994f))

/* Counts in units of 2^-z_shift, kept below 2^30 so that the difference of two states fits 32 bits */
#define EPF_UNITS_(counts, z_shift)                         \
    ((counts)*EPF_POWER_(z_shift) < 1073741824.0f           \
         ? EPF_CAST_(int32_t, (counts)*EPF_POWER_(z_shift)) \
         : 1073741823)

/* The quantities that become integers: forces over sigma_0 in counts, f_max in lsb.f */
#define EPF_COUNTS_(force, sigma_0, lsb_x)           ((force) / (sigma_0) / (lsb_x))
#define EPF_V_S_INVERSE_(v_s, lsb_v)                 ((lsb_v) / (v_s))
#define EPF_VISCOUS_(sigma_2, sigma_0, lsb_x, lsb_v) ((sigma_2) / (sigma_0) * ((lsb_v) / (lsb_x)))
#define EPF_DAMPING_(sigma_1, sigma_0, lsb_t)        ((sigma_1) / (sigma_0) / (lsb_t))

/* Their conditions, each written once */
#define EPF_LSB_X_OK_(lsb_x, z_max, z_c, z_ba, z_shift)                    \
    (EPF_POSITIVE_(lsb_x) && (z_max) <= 1073741824.0f && (z_ba) >= 1.0f && \
     EPF_UNITS_(z_ba, z_shift) < EPF_UNITS_(z_c, z_shift))
#define EPF_LSB_V_OK_(lsb_v, v_s_inverse, viscous)                    \
    (EPF_POSITIVE_(lsb_v) && (v_s_inverse) >= 1.0f / 8589934592.0f && \
     (v_s_inverse) < 16777216.0f && (viscous) < 16777216.0f)
#define EPF_LSB_F_OK_(lsb_f, f_max, largest) \
    (EPF_POSITIVE_(lsb_f) && (f_max) >= 1.0f && (f_max) <= (largest))
#define EPF_LSB_T_OK_(lsb_t, damping) (EPF_POSITIVE_(lsb_t) && (damping) < 16777216.0f)

#define EPF_Q31_LARGEST_ 2147483520.0f /* the largest float that is an int32_t */
#define EPF_Q15_LARGEST_ 32767.0f

/* All of them as one constant expression, 0 or an error */
#define EPF_REQUIRE_LSB_(sigma_0, sigma_1, sigma_2, f_c, f_max, v_s, z_ba, lsb_x, lsb_v, lsb_f, \
                         lsb_t, largest)                                                        \
    (EPF_REQUIRE_(EPF_LSB_X_OK_(lsb_x, EPF_COUNTS_(f_max, sigma_0, lsb_x),                      \
                                EPF_COUNTS_(f_c, sigma_0, lsb_x), (z_ba) / (lsb_x),             \
                                EPF_Z_SHIFT_(EPF_COUNTS_(f_max, sigma_0, lsb_x))),              \
                  lsb_x_must_be_at_most_z_ba_and_not_far_too_fine) +                            \
     EPF_REQUIRE_(EPF_LSB_V_OK_(lsb_v, EPF_V_S_INVERSE_(v_s, lsb_v),                            \
                                EPF_VISCOUS_(sigma_2, sigma_0, lsb_x, lsb_v)),                  \
                  lsb_v_must_be_positive_and_not_far_from_v_s) +                                \
     EPF_REQUIRE_(EPF_LSB_F_OK_(lsb_f, (f_max) / (lsb_f), largest),                             \
                  lsb_f_must_be_at_most_f_max_which_must_fit) +                                 \
     EPF_REQUIRE_(EPF_LSB_T_OK_(lsb_t, EPF_DAMPING_(sigma_1, sigma_0, lsb_t)),                  \
                  lsb_t_must_be_positive_and_not_far_too_fine))

/* The smallest displacement of 2 z_max or more, in counts */
#define EPF_LEAP_(z_max, z_shift) (((2u * EPF_CAST_(uint32_t, z_max) - 1u) >> (z_shift)) + 1u)

/* The leading bits of x, so many of them that the highest weighs 2^EPF_EXPONENT_(x) */
#define EPF_LEADING_(type, x, bits) EPF_CAST_(type, EPF_SCALED_(x, (bits)-1 - EPF_EXPONENT_(x)))

/*
 * The gain g = x 2^power with a limit, so that what it is applied to need not be normalised: all of it
 * stays below 2^top.
 *
 * For epf_q31 |v| g is ((min(|v|, limit) << up) mantissa) 2^-32.
 */
#define EPF_Q31_GAIN_(x, power, top)                                                        \
    {                                                                                       \
        EPF_CAST_(uint32_t, EPF_GAIN_EXPONENT_(x, power) < (top)                            \
                                ? EPF_SCALED_(x, (power) + 32 - EPF_Q31_UP_(x, power, top)) \
                                : EPF_BELOW_POWER_((top) + 1)),                             \
            EPF_CAST_(uint32_t, EPF_Q31_UP_(x, power, top) == 0 ? 2147483648.0f             \
                                : EPF_GAIN_EXPONENT_(x, power) < (top)                      \
                                    ? EPF_BELOW_POWER_((top) - (power)) / (x)               \
                                    : 1.0f),                                                \
            EPF_CAST_(uint8_t, EPF_Q31_UP_(x, power, top))                                  \
    }
#define EPF_GAIN_EXPONENT_(x, power) (EPF_EXPONENT_(x) + (power))
#define EPF_Q31_UP_(x, power, top)                  \
    (EPF_GAIN_EXPONENT_(x, power) >= (top)     ? 31 \
     : EPF_GAIN_EXPONENT_(x, power) < (top)-31 ? 0  \
                                               : EPF_GAIN_EXPONENT_(x, power) + 32 - (top))

/* For epf_q15 it is (min(|v|, limit) mantissa) 2^-shift, in 32 bits, and top is 28. Three members. */
#define EPF_Q15_GAIN_(x, power)                                                  \
    EPF_CAST_(uint32_t, EPF_GAIN_EXPONENT_(x, power) < 28                        \
                            ? EPF_SCALED_(x, (power) + EPF_Q15_SHIFT_(x, power)) \
                            : EPF_BELOW_POWER_(31)),                             \
        EPF_CAST_(uint16_t, EPF_GAIN_EXPONENT_(x, power) < 13 ? 32768.0f         \
                            : EPF_GAIN_EXPONENT_(x, power) < 28                  \
                                ? EPF_BELOW_POWER_(28 - (power)) / (x)           \
                                : 1.0f),                                         \
        EPF_CAST_(uint8_t, EPF_Q15_SHIFT_(x, power))
#define EPF_Q15_SHIFT_(x, power)               \
    (EPF_GAIN_EXPONENT_(x, power) > 12    ? 3  \
     : EPF_GAIN_EXPONENT_(x, power) < -16 ? 31 \
                                          : 15 - EPF_GAIN_EXPONENT_(x, power))

/* |v|/v_s for epf_q15: (min(|v|, limit) mantissa) 2^-16 in Q10, up to 60. Two members. */
#define EPF_Q15_RATIO_(x)                                           \
    EPF_CAST_(uint32_t, ((x) < 60.0f ? (x) : 60.0f) * 67108864.0f), \
        EPF_CAST_(uint16_t, (x)*32768.0f <= 60.0f ? 32768.0f        \
                            : (x) < 60.0f         ? 60.0f / (x)     \
                                                  : 1.0f)

/*
 * The members of the coefficients, in their order: from z_max, z_c, z_ba in counts; lsb.v/v_s; the viscous
 * force of one lsb.v in sigma_0 lsb.x; sigma_1/sigma_0 in lsb.t; f_max in lsb.f. The form comes first,
 * with the conditions: the first error is then the cause, whatever else a bad parameter does.
 */
#define EPF_Q31_DERIVE_(z_max, z_c, z_ba, v_s_inverse, viscous, damping, f_max, stribeck, update, \
                        z_shift)                                                                  \
    {                                                                                             \
        (stribeck), (update), EPF_FIXED_LENGTHS_(z_max, z_c, z_ba, z_shift),                      \
            EPF_LEAP_(EPF_UNITS_(z_max, z_shift), z_shift), EPF_Q31_GAIN_(v_s_inverse, 20, 30),   \
            EPF_Q31_GAIN_(viscous, (z_shift)-8, 28),                                              \
            EPF_DAMPING_LEADING_(uint32_t, damping, 31, 6),                                       \
            EPF_CAST_(int8_t, EPF_AT_LEAST_(EPF_EXPONENT_(damping), 6) - 37),                     \
            EPF_LEADING_(uint32_t, (f_max) / (z_max), 24),                                        \
            EPF_CAST_(uint8_t, 23 + (z_shift)-EPF_EXPONENT_((f_max) / (z_max))),                  \
            EPF_CAST_(uint8_t, z_shift)                                                           \
    }

#define EPF_Q15_DERIVE_(z_max, z_c, z_ba, v_s_inverse, viscous, damping, f_max, stribeck, update, \
                        z_shift)                                                                  \
    {                                                                                             \
        (stribeck), (update), EPF_FIXED_LENGTHS_(z_max, z_c, z_ba, z_shift),                      \
            EPF_Q15_RATIO_(v_s_inverse),                                                          \
            EPF_Q15_LEAP_(EPF_LEAP_(EPF_UNITS_(z_max, z_shift), z_shift)),                        \
            EPF_Q15_GAIN_(viscous, (z_shift)-8),                                                  \
            EPF_CAST_(int8_t, EPF_AT_LEAST_(EPF_EXPONENT_(damping), -9) - 22),                    \
            EPF_DAMPING_LEADING_(uint16_t, damping, 15, -9),                                      \
            EPF_LEADING_(uint16_t, (f_max) / (z_max), 16),                                        \
            EPF_CAST_(uint8_t, (z_shift)-10 - EPF_EXPONENT_((f_max) / (z_max))),                  \
            EPF_CAST_(uint8_t, z_shift)                                                           \
    }

/* The leading bits of the damping; so small a one that it would need too long a shift has fewer */
#define EPF_AT_LEAST_(n, least) ((n) > (least) ? (n) : (least))
#define EPF_DAMPING_LEADING_(type, x, highest, least) \
    EPF_CAST_(type, EPF_SCALED_(x, (highest)-EPF_AT_LEAST_(EPF_EXPONENT_(x), least)))

#define EPF_FIXED_LENGTHS_(z_max, z_c, z_ba, z_shift)                                \
    EPF_UNITS_(z_max, z_shift), EPF_UNITS_(z_c, z_shift), EPF_UNITS_(z_ba, z_shift), \
        EPF_CAST_(uint32_t, 1) << (z_shift)

#define EPF_Q15_LEAP_(leap) EPF_CAST_(uint16_t, (leap) < 65535u ? (leap) : 65535u)

/* From SI units to the arguments of a DERIVE */
#define EPF_FIXED_DERIVE_(derive, sigma_0, sigma_1, sigma_2, f_c, f_max, v_s, z_ba, stribeck,      \
                          update, lsb_x, lsb_v, lsb_f, lsb_t)                                      \
    derive(EPF_COUNTS_(f_max, sigma_0, lsb_x), EPF_COUNTS_(f_c, sigma_0, lsb_x), (z_ba) / (lsb_x), \
           EPF_V_S_INVERSE_(v_s, lsb_v), EPF_VISCOUS_(sigma_2, sigma_0, lsb_x, lsb_v),             \
           EPF_DAMPING_(sigma_1, sigma_0, lsb_t), (f_max) / (lsb_f), stribeck, update,             \
           EPF_Z_SHIFT_(EPF_COUNTS_(f_max, sigma_0, lsb_x)))

/* Checked, with every number a float: the fields of epf_params_t, then those of epf_lsb_t, in their order */
#define EPF_FIXED_COEFFS_(derive, largest, ...) EPF_FIXED_NAMED_(derive, largest, __VA_ARGS__)
#define EPF_FIXED_NAMED_(derive, largest, sigma_0, sigma_1, sigma_2, f_c, f_max, v_s, z_ba,       \
                         stribeck, update, lsb_x, lsb_v, lsb_f, lsb_t)                            \
    EPF_FIXED_CHECKED_(derive, largest, EPF_CAST_(float, sigma_0), EPF_CAST_(float, sigma_1),     \
                       EPF_CAST_(float, sigma_2), EPF_CAST_(float, f_c), EPF_CAST_(float, f_max), \
                       EPF_CAST_(float, v_s), EPF_CAST_(float, z_ba), stribeck, update,           \
                       EPF_CAST_(float, lsb_x), EPF_CAST_(float, lsb_v), EPF_CAST_(float, lsb_f), \
                       EPF_CAST_(float, lsb_t))
#define EPF_FIXED_CHECKED_(derive, largest, sigma_0, sigma_1, sigma_2, f_c, f_max, v_s, z_ba,     \
                           stribeck, update, lsb_x, lsb_v, lsb_f, lsb_t)                          \
    EPF_FIXED_DERIVE_(derive, sigma_0, sigma_1, sigma_2, f_c, f_max, v_s, z_ba,                   \
                      EPF_CAST_(epf_stribeck_t,                                                   \
                                (stribeck) +                                                      \
                                    EPF_REQUIRE_PARAMS_(sigma_0, sigma_1, sigma_2, f_c, f_max,    \
                                                        v_s, z_ba, stribeck, update) +            \
                                    EPF_REQUIRE_LSB_(sigma_0, sigma_1, sigma_2, f_c, f_max, v_s,  \
                                                     z_ba, lsb_x, lsb_v, lsb_f, lsb_t, largest)), \
                      update, lsb_x, lsb_v, lsb_f, lsb_t)

#endif
