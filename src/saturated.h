/* SPDX-License-Identifier: MIT */
/* The update rule of the paper, EPF_UPDATE_SATURATED, for both fixed-point variants. */
#ifndef EPF_SATURATED_H
#define EPF_SATURATED_H

#include <stdint.h>

/*
 * zeta' - zeta below z_ss, from the gap z_ss - zeta > 0 and the displacement d > 0, of which a part is
 * plastic: cases 2 and 3.
 */
/*@ requires 0 < gap && 0 <= plastic < d;
    assigns \nothing;

    // Theorem 1: the state does not pass z_ss
    ensures \result <= gap;
    // Lemma 1: the deflection changes by between nothing and the displacement...
    ensures 0 < \result <= d;
    // ...strict progress, from which Theorem 2 follows: z_ss is reached exactly, in finitely many steps
    // Lemma 2: plastic displacement has the direction of the motion
    ensures d - \result >= 0;
    // The elastic identity: what is not plastic and stays below z_ss is all deflection, to the unit
    ensures plastic == 0 && d <= gap ==> \result == d;
    ensures \result == gap || \result == d - plastic;
*/
static inline int32_t saturated(int32_t gap, int32_t d, int32_t plastic)
{
    const int32_t y = d - plastic; /* (12) */
    return y < gap ? y : gap;      /* (13) */
}

#endif
