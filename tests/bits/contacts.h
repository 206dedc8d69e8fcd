/* SPDX-License-Identifier: MIT */
/* Contacts of the three Stribeck forms as lists for the macros, and the weights of their signals. */
#ifndef EPF_TESTS_CONTACTS_H
#define EPF_TESTS_CONTACTS_H

#define TABLE_1 \
    1e5f, 63.0f, 0.0f, 1.0f, 1.1f, 1e-5f, 8e-6f, EPF_STRIBECK_LORENTZIAN, EPF_UPDATE_SATURATED
#define TABLE_2 \
    1e5f, 1e3f, 0.4f, 1.0f, 1.5f, 1e-3f, 8e-6f, EPF_STRIBECK_GAUSSIAN, EPF_UPDATE_SATURATED
#define ROTARY \
    2.3e3f, 1.7f, 0.06f, 0.35f, 0.52f, 0.02f, 9e-5f, EPF_STRIBECK_LORENTZIAN, EPF_UPDATE_SATURATED
#define COULOMB \
    8e4f, 40.0f, 0.2f, 0.8f, 1.0f, 1e-3f, 6e-6f, EPF_STRIBECK_COULOMB, EPF_UPDATE_SATURATED

/* A fine encoder, one of a thousand counts to z_max, and a coarse one */
#define TABLE_1_LSB 1e-9f, 1e-7f, 1e-4f, 1e-5f
#define TABLE_2_LSB 1.5e-8f, 1e-5f, 1e-4f, 1e-5f
#define ROTARY_LSB  9e-5f, 2e-4f, 2e-5f, 1e-4f
#define COULOMB_LSB 7e-7f, 7e-6f, 5e-5f, 1e-5f

#endif
