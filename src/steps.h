/* SPDX-License-Identifier: MIT */
/* How far the deflection goes in one step: what the theorems rest on, in both update rules and both
   fixed-point variants. */
#ifndef EPF_STEPS_H
#define EPF_STEPS_H

#include <stdint.h>

/*
 * dzeta = zeta' - zeta below z_ss: eq. (13), cases 2 and 3. From y of eq. (12), what of the displacement
 * d is not plastic, 0 < y <= d, and from the gap z_ss - zeta > 0.
 */
/*@ requires 0 < gap && 0 < y;
    assigns \nothing;
    // Theorem 1: the state does not pass z_ss
    ensures \result <= gap;
    // Lemmas 1 and 2: the deflection changes by between nothing and the displacement; strict progress,
    // from which Theorem 2 follows: z_ss is reached exactly, in finitely many steps
    ensures 0 < \result <= y;
    // The elastic identity: what is not plastic and stays below z_ss is all deflection, to the unit
    ensures y <= gap ==> \result == y;
    ensures y >= gap ==> \result == gap;
*/
static inline int32_t within_gap(int32_t y, int32_t gap)
{
    return y < gap ? y : gap;
}

/*
 * zeta - zeta' above z_ss: case 1, where it takes many displacements. From the part of the excess
 * zeta - z_ss that one of them lets go, rounded down.
 */
/*@ requires 0 <= excess;
    assigns \nothing;
    // Theorems 1 and 2 from above: strictly towards z_ss, and not beyond; exactly there in finitely
    // many steps
    ensures 0 <= \result <= excess;
    ensures 0 < excess ==> 0 < \result;
    ensures part >= excess ==> \result == excess;
*/
static inline int32_t relaxed(uint32_t part, int32_t excess)
{
    return part < (uint32_t)excess ? (int32_t)part + 1 : excess;
}

#endif
