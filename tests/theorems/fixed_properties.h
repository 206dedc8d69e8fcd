/* SPDX-License-Identifier: MIT */
/*
 * What q31.h and q15.h promise of every step, whatever the inputs: all of it exactly, none with a
 * tolerance. Each is a visitor of a step, and fails by fixed_check.
 */
#ifndef EPF_TESTS_FIXED_PROPERTIES_H
#define EPF_TESTS_FIXED_PROPERTIES_H

#include "fixed_step.h"

/* Theorem 1 */
void state_is_bounded(const fixed_step_t *step);
/* Lemma 1, with strict progress */
void deflects_by_part_of_the_displacement(const fixed_step_t *step);
/* Lemma 2 */
void plastic_displacement_follows_the_motion(const fixed_step_t *step);
void elastic_displacement_is_all_deflection(const fixed_step_t *step);
/* Theorem 2 from above, and at once */
void approaches_steady_state_from_above(const fixed_step_t *step);
void leap_arrives(const fixed_step_t *step);
/* Theorem 3 */
void force_opposes_plastic_motion(const fixed_step_t *step);
/* Theorem 4 */
void no_step_yields_energy(const fixed_step_t *step);

void published_force_is_the_rounded_one(const fixed_step_t *step);
void rejected_counts_times_of_0(const fixed_step_t *step);
void split_calls_leave_the_same_contact(const fixed_step_t *step);
void negated_inputs_negate_outputs(const fixed_step_t *step);

/* All of these */
void fixed_check_all(const fixed_step_t *step);

#endif
