/* SPDX-License-Identifier: MIT */
/*
 * One contact, as a differential equation of its deflection z:
 *
 *     dz/dt = v - alpha |v| z/z_ss(v)       f = sigma_0 z + sigma_1 dz/dt + sigma_2 v
 *
 * and the models that it is compared with, which differ in alpha, z_ss and sigma_1.
 */
#ifndef PLANT_CONTACT_H
#define PLANT_CONTACT_H

#include "friction.h"

typedef enum {
    CONTACT_ELASTO_PLASTIC, /* alpha of eq. (10) */
    CONTACT_LUGRE,          /* alpha = 1 */
    CONTACT_DAHL,           /* alpha = 1, f_ss = f_c, sigma_1 = 0 */
    CONTACT_COULOMB         /* no z: |f| = f_c, and at rest whatever holds the mass, up to f_c */
} contact_model_t;

typedef struct {
    friction_t friction;
    contact_model_t model;
} contact_t;

/* dz/dt, m/s; 0 for Coulomb */
double contact_rate(const contact_t *contact, double z, double v);

/* The force at a velocity, N; for Coulomb at rest 0 (see slide.h for what holds a mass) */
double contact_force(const contact_t *contact, double z, double v);

/* The energy stored in the deflection, sigma_0 z^2/2, J */
double contact_energy(const contact_t *contact, double z);

#endif
