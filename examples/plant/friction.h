/* SPDX-License-Identifier: MIT */
/*
 * The friction of the paper in double precision: parameters, and what follows from the velocity.
 * Equation numbers are those of the paper (see include/epf/params.h); nothing of the library is used.
 */
#ifndef PLANT_FRICTION_H
#define PLANT_FRICTION_H

/* The form of f_ss(v) */
typedef enum { FRICTION_LORENTZIAN, FRICTION_GAUSSIAN, FRICTION_COULOMB } friction_form_t;

/* SI units */
typedef struct {
    double sigma_0, sigma_1, sigma_2; /* N/m, N s/m, N s/m */
    double f_c, f_max;                /* N */
    double v_s;                       /* m/s */
    double z_ba;                      /* m */
    friction_form_t form;
} friction_t;

/* Tables I and II of the paper: with a mass of 1 kg, and of 10 kg */
extern const friction_t friction_table_1, friction_table_2;

/* Eqs. (6) to (8), N: signed, and 0 at rest */
double friction_f_ss(const friction_t *p, double v);

/* Eq. (9), m: |z_ss(v)|, and z_max at rest */
double friction_z_ss(const friction_t *p, double v);

/* The largest deflection, f_max/sigma_0, m */
double friction_z_max(const friction_t *p);

/* Eq. (10), where z_ss is |z_ss(v)| and z along the motion is positive: 0 up to z_ba, 1 from z_ss on */
double friction_alpha(const friction_t *p, double z_along, double z_ss);

#endif
