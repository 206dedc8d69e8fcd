/* SPDX-License-Identifier: MIT */
/**
 * @file fixed.h
 * What the two fixed-point variants share: the integer signals and their weights, the coefficients,
 * and the state of a contact. Include q31.h or q15.h; read this page for the numbers.
 *
 * Signals are plain integers in units that the user gives as an epf_lsb_t: encoder counts, counts
 * per second, timer ticks, DAC or PWM or millinewton units. Nothing is scaled by the user.
 *
 *     signal         unit                                  held as
 *     dx, v, f, dt   lsb.x, lsb.v, lsb.f, lsb.t            int32_t or int16_t, dt unsigned
 *     z              u = lsb.x 2^-z_shift                  int32_t, |z| <= z_max < 2^30
 *     force inside   sigma_0 u, and 2^8 of them            z + 2^8 rest: sigma_0 z is exact
 *
 * z_shift is the largest that keeps z_max within 2^30 u. A displacement thus enters the state by a
 * shift, exactly, and in the elastic regime it leaves it exactly: there is no drift, for ever.
 * In SI units z is z lsb.x 2^-z_shift metres.
 *
 * Choosing the weights. lsb.x is what the encoder gives. lsb.v well below v_s, v_s/100 say: a speed
 * that rounds to 0 counts as rest, where z_ss = f_max/sigma_0. For q15, lsb.f of f_max/16000 leaves
 * room for the damping and viscous terms, and lsb.x of z_max/16000 or coarser lets every displacement
 * short of 2 z_max fit 16 bits. Saturate what does not fit its type, a displacement or a velocity, or
 * a dt beyond the range of the timer; never let it wrap.
 */
#ifndef EPF_FIXED_H
#define EPF_FIXED_H

#include "epf/params.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A real coefficient, mantissa 2^-shift, with 2^23 <= mantissa < 2^24, or less below 2^-33; or 0. */
typedef struct {
    uint32_t mantissa;
    int8_t shift;
} epf_gain_t;

/**
 * What the estimator needs of the parameters, made once. Constant from then on: it may live in flash
 * and be shared by any number of estimators of the variant that it was made for, whose forces it
 * fits. Read it freely, change it never.
 */
typedef struct {
    int32_t z_max;           /**< f_max/sigma_0, u: no state is ever larger; 2^29 to 2^30 */
    int32_t z_c;             /**< f_c/sigma_0, u */
    int32_t z_ba;            /**< break-away deflection, u; at least one count of displacement */
    uint32_t unit;           /**< one count of displacement, u: 2^z_shift */
    uint32_t leap;           /**< the smallest displacement of 2 z_max or more, counts */
    epf_gain_t v_s_inverse;  /**< lsb.v/v_s */
    epf_gain_t viscous;      /**< viscous force of one lsb.v, 2^8 sigma_0 u */
    epf_gain_t damping;      /**< sigma_1/sigma_0, lsb.t */
    epf_gain_t output;       /**< sigma_0 u, lsb.f */
    uint8_t z_shift;         /**< 0 to 29 */
    epf_stribeck_t stribeck; /**< form of f_ss(v) */
} epf_fixed_coeffs_t;

/** All that follows from the velocity alone. Private. */
typedef struct {
    int32_t z_ss;        /* |z_ss(v)|, u */
    int32_t viscous;     /* sigma_2 v, 2^8 sigma_0 u */
    uint32_t inv_span;   /* 1/(z_ss - z_ba), as quotient() takes it */
    uint32_t span_share; /* (z_ss - z_ba)/z_ss */
    uint8_t span_zeros;  /* leading zeros of z_ss - z_ba */
} epf_fixed_point_t;

/** One contact. Allocate it anywhere, initialise it. Only `rejected` is public. */
typedef struct {
    const epf_fixed_coeffs_t *coeffs;
    int32_t z;                   /* z_k, u */
    int32_t dz;                  /* z_k - z_{k-1}, u */
    int32_t force;               /* as last published, lsb.f */
    uint16_t rejected;           /**< unusable values (dt = 0) since init; stays at UINT16_MAX */
    int8_t direction;            /* sgn(dx_k) */
    uint8_t published;           /* index of the published operating point */
    epf_fixed_point_t points[2]; /* the published one, and the one being prepared */
} epf_fixed_t;

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

#ifdef __cplusplus
}
#endif

#endif
