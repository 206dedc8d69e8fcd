/* SPDX-License-Identifier: MIT */
/*
 * Drives both fixed-point estimators, by both update rules, through every sequence, for every contact,
 * with encoders from coarse to fine and sigma_1 well inside and far outside of eq. (22), and shows each
 * step to a visitor. The twin of f32_walk.h.
 */
#ifndef EPF_TESTS_FIXED_WALK_H
#define EPF_TESTS_FIXED_WALK_H

#include "fixed_step.h"

typedef void (*fixed_visitor_t)(const fixed_step_t *step);

/* The contacts of parameter_sets.h; on an emulated core fewer samples: see effort.h */
void fixed_walk(unsigned samples, fixed_visitor_t visit);

/* The corners of the parameters, with every z_shift: see fixed_corners.h */
void fixed_walk_corners(unsigned samples, fixed_visitor_t visit);

/* The corners once more, each step from a state of its own: anywhere, and next to z_ba and z_ss; by
   displacements and velocities of every length, and ones that just reach a multiple of z_ss/2 */
void fixed_scatter(unsigned samples, fixed_visitor_t visit);

/* One variant and one contact, by both rules whatever the parameters say */
void fixed_walk_contact(const fixed_variant_t *variant, const char *contact,
                        const epf_params_t *params, const epf_lsb_t *lsb, unsigned samples,
                        fixed_visitor_t visit);

#endif
