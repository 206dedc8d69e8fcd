/* SPDX-License-Identifier: MIT */
/* What eq. (14) adds to sigma_0 z, with the passivity guard, for both fixed-point variants. */
#ifndef EPF_GUARD_H
#define EPF_GUARD_H

#include "numbers.h"

/* No state reaches this, in u: the difference of two states fits 32 bits */
#define STATE_LIMIT 1073741824

/* Neither the damping nor the viscous term is larger, in units of 256 sigma_0 u: 128 f_max at the
   least. The sum of the two fits 32 bits with room. */
#define TERM_MAX 536870912u

/*
 * The viscous and the damping term along the motion in case 1, in units of 256 sigma_0 u. There the
 * deflection shrinks, so that the damping term opposes the other terms: it is limited to 1 - 2^-10 of
 * them.
 */
/*@ requires 0 < zeta < STATE_LIMIT; // Theorem 1, in case 1
    requires viscous <= TERM_MAX && damping <= TERM_MAX;
    assigns \nothing;
    ensures -TERM_MAX <= \result <= TERM_MAX;
    // Theorem 3: the guard leaves the force the direction of the motion
    ensures zeta + 256 * \result > 0;
*/
static inline int32_t guarded(int32_t zeta, uint32_t viscous, uint32_t damping)
{
    const uint32_t others = (uint32_t)zeta / 256u + viscous;
    const uint32_t most = others == 0 ? 0 : others - others / 1024u - 1u;
    return (int32_t)viscous - (int32_t)(damping < most ? damping : most);
}

#endif
