/* SPDX-License-Identifier: MIT */
/*
 * The estimator once more, in double precision and with libm, written from the equations of the
 * paper in their signed form and sharing nothing with the library but its parameter struct.
 */
#ifndef EPF_TESTS_ORACLE_H
#define EPF_TESTS_ORACLE_H

#include "epf/params.h"

double oracle_fss(const epf_params_t *p, double v);             /* eqs. (6) to (8), N */
double oracle_zss(const epf_params_t *p, double v);             /* eq. (9), m; signed */
double oracle_alpha(const epf_params_t *p, double z, double v); /* eq. (10) */

/* z_k from z_{k-1}; the direction is that of dx, of v only the magnitude counts */
double oracle_update(const epf_params_t *p, double z, double dx, double v);

/* The same by EPF_UPDATE_MEAN_VALUE */
double oracle_mean_value(const epf_params_t *p, double z, double dx, double v);

/* eq. (14) as printed, and with the damping term limited in case 1 */
double oracle_force(const epf_params_t *p, double z_before, double z, double dx, double v,
                    double dt);
double oracle_guarded_force(const epf_params_t *p, double z_before, double z, double dx, double v,
                            double dt);

/* z after the displacement dx at constant v by the continuous model dz/dx = 1 - alpha z/z_ss,
   integrated in so many steps of Runge-Kutta's fourth-order rule */
double oracle_continuous(const epf_params_t *p, double z, double dx, double v, unsigned steps);

#endif
