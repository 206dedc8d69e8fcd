/* SPDX-License-Identifier: MIT */
/*
 * Theorems 2, 3 and 4, for the provers only: the shipped update rule and guard put together as a step
 * puts them, and the theorems in mathematical integers. Nothing here is compiled into the library.
 */
#include "guard.h"
#include "steps.h"

/* The internal force of one step, f = zeta' + 2^8 (the other terms), eq. (14), in sigma_0 u. y is what a
   variant makes of eq. (12): any part of d but none, and all of it up to z_ba. */
/*@ requires \valid(next);
    requires 0 < z_ba < z_ss < STATE_LIMIT;
    requires -STATE_LIMIT < zeta < STATE_LIMIT;
    requires 0 < y <= d;
    requires zeta <= z_ba ==> y == d;
    requires viscous <= TERM_MAX && damping <= TERM_MAX;
    assigns *next;

    // Theorem 3: wherever displacement is plastic, dw = d - (zeta' - zeta) > 0, the force opposes it
    ensures d - (*next - zeta) > 0 ==> \result > 0;
    // Theorem 4, doubled: 2 f d > 2 (W' - W) with W = zeta^2/2
    ensures 2 * \result * d > *next * *next - zeta * zeta;
*/
static int64_t internal_force(int32_t zeta, int32_t d, int32_t y, int32_t z_ss, int32_t z_ba,
                              uint32_t viscous, uint32_t damping, int32_t *next)
{
    const int32_t gap = z_ss - zeta;
    const int32_t dzeta = gap > 0 ? saturated(y, gap) : gap;
    *next = zeta + dzeta;
    const int32_t terms =
        dzeta < 0 ? guarded(*next, viscous, damping) : (int32_t)(viscous + damping);
    const int64_t force = *next + 256 * (int64_t)terms;
    /*@ ghost int64_t dw = d - (int64_t)dzeta; */
    /*@ assert (zeta < z_ss ==> 0 < dzeta <= d) && dw >= 0; */
    /*@ assert dw > 0 ==> *next > z_ba; */
    /*@ assert dzeta >= 0 ==> force >= *next; */
    /*@ assert dzeta < 0 ==> force > 0 && *next == z_ss && zeta > z_ss; */
    /* Case 1: work is positive, and the store shrinks */
    /*@ assert dzeta < 0 ==> force * d > 0; */
    /*@ assert dzeta < 0 ==> *next * *next < zeta * zeta; */
    /* Else, by 2 zeta' d - (zeta'^2 - zeta^2) = 2 zeta' dw + dzeta^2 */
    /*@ assert 2 * *next * d - (*next * *next - zeta * zeta) == 2 * (*next * dw) + dzeta * dzeta; */
    /*@ assert dzeta >= 0 ==> *next * dw >= 0; */
    /*@ assert dzeta >= 0 ==> *next * dw > 0 || dzeta * dzeta > 0; */
    /*@ assert dzeta >= 0 ==> 2 * *next * d > *next * *next - zeta * zeta; */
    /*@ assert dzeta >= 0 ==> force * d >= *next * d; */
    /*@ assert dzeta >= 0 ==> 2 * force * d > *next * *next - zeta * zeta; */
    /*@ assert dzeta < 0 ==> 2 * force * d > *next * *next - zeta * zeta; */
    return force;
}

/* What a variant makes of eq. (12), whatever its alpha: any part of d but none */
/*@ requires 0 < d;
    assigns \nothing;
    ensures 0 < \result <= d;
*/
static int32_t any_deflecting_part(int32_t zeta, int32_t d);

/*@ requires 0 < z_ss < STATE_LIMIT && -STATE_LIMIT < zeta < STATE_LIMIT && 0 < d;
    assigns \nothing;
    // Theorem 2: steady motion ends in z_ss exactly; the loop variant says: in finitely many steps
    ensures \result == z_ss;
*/
static int32_t steady_motion(int32_t zeta, int32_t d, int32_t z_ss)
{
    /*@ loop invariant -STATE_LIMIT < zeta < STATE_LIMIT;
        loop assigns zeta;
        loop variant zeta == z_ss ? 0 : zeta > z_ss ? 1 : z_ss - zeta;
    */
    while (zeta != z_ss) {
        const int32_t gap = z_ss - zeta;
        zeta += gap > 0 ? saturated(any_deflecting_part(zeta, d), gap) : gap;
    }
    return zeta;
}
