/* SPDX-License-Identifier: MIT */
/**
 * @file params.h
 * The friction model: its parameters in SI units, and the conditions that they must meet.
 *
 * Equation numbers, here and in the whole library, are those of Hayward, Armstrong, Altpeter and
 * Dupont, "Discrete-Time Elasto-Plastic Friction Estimation", IEEE Transactions on Control Systems
 * Technology, 2009. For a rotating joint read rad for m and N m for N.
 *
 *     force                      f_max ....---.
 *       |            .-----------.             `--.         f_ss(v), eqs. (6) to (8):
 *       |         .'  mixed      : sliding  f_c    `-----   from f_max at rest down to f_c
 *       |       /                :                          as |v| passes v_s
 *       |     / elastic          :
 *       |   / slope sigma_0      :
 *       +--/------+--------------+------> displacement since the reversal
 *          0     z_ba        z_ss = f_ss/sigma_0
 */
#ifndef EPF_PARAMS_H
#define EPF_PARAMS_H

#include "epf/detail/names.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Outcome of a check or of an initialisation: one value per cause. */
typedef enum {
    EPF_OK = 0,
    EPF_ERR_NULL,       /**< a pointer is null */
    EPF_ERR_NOT_FINITE, /**< a parameter is NaN or infinite */
    EPF_ERR_SIGMA_0,    /**< sigma_0 is not positive */
    EPF_ERR_SIGMA_1,    /**< sigma_1 is negative */
    EPF_ERR_SIGMA_2,    /**< sigma_2 is negative */
    EPF_ERR_F_C,        /**< f_c is not positive */
    EPF_ERR_F_MAX,      /**< f_max is below f_c */
    EPF_ERR_V_S,        /**< v_s is not positive */
    EPF_ERR_Z_BA,       /**< z_ba is not between 0 and z_c = f_c/sigma_0 */
    EPF_ERR_STRIBECK,   /**< stribeck is not a form that this build has */
    EPF_ERR_UPDATE,     /**< update is not a rule that this build has */
    EPF_ERR_LSB_X,      /**< lsb.x is not positive, too coarse for z_ba or too fine for z_max */
    EPF_ERR_LSB_V,      /**< lsb.v is not positive, or far from v_s and sigma_2 */
    EPF_ERR_LSB_F,      /**< lsb.f is not positive, or f_max is not within its integers */
    EPF_ERR_LSB_T,      /**< lsb.t is not positive, or far too fine for sigma_1 */
    EPF_ERR_RANGE       /**< valid one by one, but a derived value leaves the number format */
} epf_status_t;

/**
 * The steady-state friction force f_ss(v). Where one form is enough, define EPF_STRIBECK_ONLY to it
 * for the library and for what includes it (CMake does, given -DEPF_STRIBECK_ONLY=...): the code of
 * the others is left out, and parameters with another form are refused.
 */
typedef enum {
    EPF_STRIBECK_LORENTZIAN = 0, /**< eq. (8): the default; one division, no exponential */
    EPF_STRIBECK_GAUSSIAN,       /**< eq. (7) */
    EPF_STRIBECK_COULOMB         /**< eq. (6): f_c at every speed but 0, where (9) has f_max */
} epf_stribeck_t;

/**
 * How the state advances over one displacement. Take EPF_UPDATE_MEAN_VALUE, which follows the continuous
 * model as closely as the exact solution at constant velocity does, unless you want the published
 * algorithm. Give both the mean velocity of the displacement, dx/dt, not the velocity at its end. The
 * theorems hold for both. Where one rule is enough, define EPF_UPDATE_ONLY to it, as EPF_STRIBECK_ONLY to
 * a form.
 */
typedef enum {
    EPF_UPDATE_SATURATED = 0, /**< Algorithm 1 of the paper, eqs. (12) and (13) */
    EPF_UPDATE_MEAN_VALUE     /**< (12) and (13) at a deflection inside the step */
} epf_update_t;

/**
 * Parameters of the model.
 *
 * "Positive" below means a normal number, at least FLT_MIN: cores differ in what they make of
 * smaller ones.
 */
typedef struct {
    float sigma_0; /**< stiffness of the contact, N/m; positive */
    float sigma_1; /**< damping of the contact, N s/m; >= 0; see epf_sigma_1_limit */
    float sigma_2; /**< viscous friction, N s/m; >= 0 */
    float f_c;     /**< Coulomb friction, N; positive */
    float f_max;   /**< largest static friction (break-away), N; >= f_c */
    float v_s;     /**< Stribeck velocity, m/s; positive, also where unused; above 2^126 as 2^126 */
    float z_ba;    /**< break-away deflection, m: purely elastic below it; 0 < z_ba < z_c */
    epf_stribeck_t stribeck; /**< form of f_ss(v) */
    epf_update_t update;     /**< update rule */
} epf_params_t;

/** What one least significant bit of each integer signal of the fixed-point variants weighs. */
typedef struct {
    float x; /**< displacement, m */
    float v; /**< velocity, m/s */
    float f; /**< force, N */
    float t; /**< time, s */
} epf_lsb_t;

/**
 * Tells whether the parameters meet all their conditions.
 *
 * @param params  may be null (EPF_ERR_NULL).
 * @return EPF_OK, or the first cause found: not finite, then the fields in their order, then
 *         EPF_ERR_RANGE where f_max, z_max = f_max/sigma_0, or 1/(z_c - z_ba) leaves the range in
 *         which no intermediate result can overflow (f_max and z_max up to FLT_MAX/16).
 *
 * Context: any; reentrant, touches nothing. Cost: 2 divisions and some 30 comparisons.
 */
epf_status_t epf_params_check(const epf_params_t *params);

/**
 * The largest sigma_1 for which the discrete-time estimator is dissipative by itself, eq. (22):
 *
 *     sigma_1 < sigma_0 dt f_c/(f_max - f_c) + sigma_2 |v| dt/(z_max - z_c)
 *
 * Choose sigma_1 by it, with the shortest dt and the lowest |v| that the estimator will see. Above
 * it nothing breaks: the passivity guard of the force then limits the damping term, so a larger
 * sigma_1 buys nothing while friction falls with speed.
 *
 * @param params  valid parameters.
 * @param v       velocity, m/s; only |v| matters, and NaN counts as 0.
 * @param dt      time between updates, s; > 0. On a core that flushes subnormal numbers to 0, such a v,
 *                dt or sigma_2 counts as 0.
 * @return the bound in N s/m, rounded down: by less than 1e-6 of its exact value, never up. Where
 *         the rounded value is above FLT_MAX, INFINITY: every sigma_1 will do, as where f_max = f_c, or where v is
 *         infinite and sigma_2 > 0. Where that is below FLT_MIN, 0. Also 0 for invalid parameters, or
 *         a dt that is not positive and finite. Never NaN.
 *
 * Context: design time and start-up; reentrant, touches nothing. Cost: that of epf_params_check,
 * 1 division and a dozen products.
 */
float epf_sigma_1_limit(const epf_params_t *params, float v, float dt);

/**
 * One line of English for a status, without a full stop; "unknown status" for any other value.
 *
 * Context: any; the string is constant and lives for ever. Cost: one table look-up.
 */
const char *epf_status_text(epf_status_t status);

#ifdef __cplusplus
}
#endif

#endif
