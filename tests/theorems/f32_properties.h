/* SPDX-License-Identifier: MIT */
/*
 * What design and headers promise of one step of f32 by either update rule, to the resolution of the state,
 * which has the bits of two floats: only where double holds those.
 */
#ifndef EPF_TESTS_F32_PROPERTIES_H
#define EPF_TESTS_F32_PROPERTIES_H

#include "f32_step.h"

/* The proposition of tests/proof/README.md: what an update rule must do for Theorems 1 to 4 to hold */
void f32_rises_by_no_more_than_the_displacement(const f32_step_t *step); /* (a) */
void f32_is_elastic_up_to_z_ba(const f32_step_t *step);                  /* (b) */
void f32_lets_go_from_above_z_ss(const f32_step_t *step);                /* (c) */
void f32_gap_closes(const f32_step_t *step);                             /* (d) */

/* A displacement of 2 z_max or more ends in z_ss exactly */
void f32_leap_arrives(const f32_step_t *step);

#endif
