/* SPDX-License-Identifier: MIT */
/*
 * Theorems 2, 3 and 4, for the provers only and in mathematical integers: for every dzeta that `deflection`
 * may return, by either update rule, and with the shipped guard. Nothing here is compiled into the library.
 */
#include "guard.h"

/* The internal force of one step, f = zeta' + 2^8 (the other terms), eq. (14), in sigma_0 u */
/*@ requires \valid(next);
    requires 0 < z_ba < z_ss < STATE_LIMIT;
    requires -STATE_LIMIT < zeta < STATE_LIMIT;
    requires 0 < d;
    // the proposition's (a), (b) and (c), which `deflection` ensures
    requires zeta < z_ss ==> 0 < dzeta <= d && zeta + dzeta <= z_ss;
    requires zeta < z_ss && dzeta < d ==> z_ba < zeta + dzeta;
    requires zeta > z_ss ==> z_ss <= zeta + dzeta < zeta;
    requires zeta == z_ss ==> dzeta == 0;
    requires viscous <= TERM_MAX && damping <= TERM_MAX;
    assigns *next;

    // Theorem 3: wherever displacement is plastic, dw = d - (zeta' - zeta) > 0, the force opposes it
    ensures d - (*next - zeta) > 0 ==> \result > 0;
    // Theorem 4, doubled: 2 f d > 2 (W' - W) with W = zeta^2/2
    ensures 2 * \result * d > *next * *next - zeta * zeta;
*/
static int64_t internal_force(int32_t zeta, int32_t d, int32_t dzeta, int32_t z_ss, int32_t z_ba,
                              uint32_t viscous, uint32_t damping, int32_t *next)
{
    *next = zeta + dzeta;
    const int32_t terms =
        dzeta < 0 ? guarded(*next, viscous, damping) : (int32_t)(viscous + damping);
    const int64_t force = *next + 256 * (int64_t)terms;
    /*@ ghost int64_t dw = d - (int64_t)dzeta; */
    /*@ assert dw >= 0; */
    /*@ assert dw > 0 ==> *next > z_ba; */
    /*@ assert dzeta >= 0 ==> force >= *next; */
    /*@ assert dzeta < 0 ==> force > 0 && z_ss <= *next < zeta; */
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

/* dzeta by either rule, and whatever share of a displacement is plastic: what `deflection` ensures */
/*@ requires 0 < z_ss < STATE_LIMIT && -STATE_LIMIT < zeta < STATE_LIMIT && 0 < d;
    assigns \nothing;
    ensures zeta < z_ss ==> 0 < \result <= d && zeta + \result <= z_ss;
    ensures zeta > z_ss ==> z_ss <= zeta + \result < zeta;
*/
static int32_t any_step(int32_t zeta, int32_t d, int32_t z_ss);

/*@ requires 0 < z_ss < STATE_LIMIT && -STATE_LIMIT < zeta < STATE_LIMIT && 0 < d;
    assigns \nothing;
    // Theorem 2: steady motion ends in z_ss exactly, from below and from above; the loop variant, which
    // falls, says: in finitely many steps
    ensures \result == z_ss;
*/
static int32_t steady_motion(int32_t zeta, int32_t d, int32_t z_ss)
{
    /*@ loop invariant -STATE_LIMIT < zeta < STATE_LIMIT;
        loop assigns zeta;
        loop variant zeta > z_ss ? zeta - z_ss : z_ss - zeta;
    */
    while (zeta != z_ss) {
        zeta += any_step(zeta, d, z_ss);
    }
    return zeta;
}
