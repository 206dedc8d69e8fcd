/* SPDX-License-Identifier: MIT */
/*
 * Theorems 2, 3 and 4, for the provers only: the shipped kernels put together as a step puts them,
 * and the theorems in mathematical integers. Nothing here is compiled into the library.
 */
#include "kernel.h"

/* The internal force of one step, f = zeta' + 2^8 rest, eq. (14), in sigma_0 u. Plastic is what a
   variant makes of alpha: any part of d below the whole, and none up to z_ba. */
/*@ requires \valid(next);
    requires 0 < z_ba < z_ss < STATE_LIMIT;
    requires -STATE_LIMIT < zeta < STATE_LIMIT;
    requires 0 < d && 0 <= plastic < d;
    requires plastic > 0 ==> zeta > z_ba;
    requires viscous <= TERM_MAX && damping <= TERM_MAX;
    assigns *next;

    // Theorem 3: wherever displacement is plastic, dw = d - (zeta' - zeta) > 0, the force opposes it
    ensures d - (*next - zeta) > 0 ==> \result > 0;
    // Theorem 4, doubled: 2 f d > 2 (W' - W) with W = zeta^2/2
    ensures 2 * \result * d > *next * *next - zeta * zeta;
*/
static int64_t internal_force(int32_t zeta, int32_t d, int32_t plastic, int32_t z_ss, int32_t z_ba,
                              uint32_t viscous, uint32_t damping, int32_t *next)
{
    *next = zeta < z_ss ? psi(zeta, d, plastic, z_ss) : z_ss;
    const int32_t rest = rest_along(*next, *next - zeta, viscous, damping);
    const int64_t force = *next + 256 * (int64_t)rest;
    /*@ ghost int64_t dz = *next - (int64_t)zeta; */
    /*@ ghost int64_t dw = d - dz; */
    /*@ assert (zeta < z_ss ==> 0 < dz <= d) && dw >= 0; */
    /*@ assert dw > 0 ==> *next > z_ba; */
    /*@ assert dz >= 0 ==> force >= *next; */
    /*@ assert dz < 0 ==> force > 0 && *next == z_ss && zeta > z_ss; */
    /* Case 1: work is positive, and the store shrinks */
    /*@ assert dz < 0 ==> force * d > 0; */
    /*@ assert dz < 0 ==> *next * *next < zeta * zeta; */
    /* Else, by 2 zeta' d - (zeta'^2 - zeta^2) = 2 zeta' dw + dz^2 */
    /*@ assert 2 * *next * d - (*next * *next - zeta * zeta) == 2 * (*next * dw) + dz * dz; */
    /*@ assert dz >= 0 ==> *next * dw >= 0; */
    /*@ assert dz >= 0 ==> *next * dw > 0 || dz * dz > 0; */
    /*@ assert dz >= 0 ==> 2 * *next * d > *next * *next - zeta * zeta; */
    /*@ assert dz >= 0 ==> force * d >= *next * d; */
    /*@ assert dz >= 0 ==> 2 * force * d > *next * *next - zeta * zeta; */
    /*@ assert dz < 0 ==> 2 * force * d > *next * *next - zeta * zeta; */
    return force;
}

/* Any part of d below the whole: what alpha makes of it does not matter here */
/*@ requires 0 < d;
    assigns \nothing;
    ensures 0 <= \result < d;
*/
static int32_t any_plastic_part(int32_t zeta, int32_t d);

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
        zeta = zeta < z_ss ? psi(zeta, d, any_plastic_part(zeta, d), z_ss) : z_ss;
    }
    return zeta;
}
