/* SPDX-License-Identifier: MIT */
/* The state: eqs. (12) and (13), by either update rule. Included by contact.h. */
#include "steps.h"

/*@ // What every update rule must do, see tests/proof/README.md: below z_ss progress, no more than d, and
    // not beyond z_ss (Lemma 1; Theorems 1 and 2); where part of d is plastic, an end above z_ba
    // (Lemma 2); above z_ss strictly towards it and not beyond (Theorems 1 and 2)
    predicate is_step(integer z_ba, integer z_ss, integer zeta, integer d, integer dzeta) =
      (zeta < z_ss ==> 0 < dzeta <= d && zeta + dzeta <= z_ss) &&
      (zeta < z_ss && dzeta < d ==> z_ba < zeta + dzeta) &&
      (zeta > z_ss ==> z_ss <= zeta + dzeta < zeta) &&
      (zeta == z_ss ==> dzeta == 0);
*/

/* y, eq. (12): a displacement d less its plastic part alpha zeta/z_ss, at the deflection zeta between z_ba
   and z_ss whose gap z_ss - zeta is a share w of the span z_ss - z_ba. There 1 - alpha is a half period
   of a sine of w, eq. (10), and zeta/z_ss is 1 - w span/z_ss. */
/*@ requires \valid_read(point);
    requires 0 < d;
    assigns \nothing;
    ensures 0 < \result <= d; // strict progress
*/
static IN_LINE int32_t deflecting_part(const point_t *point, fraction_t w, int32_t d)
{
    const fraction_t alpha = ONE - half_sine(w);
    const fraction_t zeta_by_z_ss = ONE - product(w, point->span_share);
    return d - (int32_t)part((uint32_t)d, product(alpha, zeta_by_z_ss));
}

#include "saturated.h"

#include "mean_value.h"

/* dzeta for so many counts of displacement, more than 0, in the direction in which z is zeta */
/*@ requires valid_coeffs(c) && \valid_read(point) && valid_point(c, point);
    requires -c->z_max <= zeta <= c->z_max;
    requires 0 < counts <= SIGNAL_MAX + 1;
    assigns \nothing;

    ensures is_step(c->z_ba, point->z_ss, zeta, counts * c->unit, \result);
    // Theorem 1: the state is bounded
    ensures -c->z_max <= zeta + \result <= c->z_max;
    // Lemma 2: no plastic displacement against the motion
    ensures \result <= counts * c->unit;
    // The elastic identity, to the unit: no drift
    ensures zeta + counts * c->unit <= c->z_ba ==> \result == counts * c->unit;
    // Theorem 2: a displacement of 2 z_max arrives at once
    ensures counts * c->unit >= 2 * c->z_max ==> zeta + \result == point->z_ss;
*/
static IN_LINE int32_t deflection(const coeffs_t *c, const point_t *point, int32_t zeta,
                                  uint32_t counts)
{
    /*@ assert counts < c->leap ==> counts * c->unit <= (c->leap - 1) * c->unit; */
    /*@ assert counts >= c->leap ==> counts * c->unit >= c->leap * c->unit; */
    if (counts >= c->leap) {
        return point->z_ss - zeta; /* a displacement of 2 z_max */
    }
    const int32_t d = (int32_t)(counts * c->unit);
    /*@ assert d == counts * c->unit && 0 < d; */
    if (d <= c->z_ba - zeta) {
        return d; /* all elastic */
    }
    return rule_in_use(c->update) == EPF_UPDATE_SATURATED ? saturated_rule(c, point, zeta, d)
                                                          : mean_value_rule(c, point, zeta, d);
}
