/* SPDX-License-Identifier: MIT */
/* The state: eqs. (12) and (13), by either update rule. Included by contact.h. */
#include "steps.h"

/* y, eq. (12): a displacement d less its plastic part alpha zeta/z_ss, at the deflection zeta between z_ba
   and z_ss whose gap z_ss - zeta is a share w of the span z_ss - z_ba. There 1 - alpha is a half period
   of a sine of w, eq. (10), and zeta/z_ss is 1 - w span/z_ss. */
/*@ requires \valid_read(point);
    requires 0 < d;
    assigns \nothing;
    ensures 0 < \result <= d; // strict progress
*/
static LEAF int32_t deflecting_part(const point_t *point, fraction_t w, int32_t d)
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

    // Theorem 1: the state is bounded
    ensures -c->z_max <= zeta + \result <= c->z_max;
    ensures zeta <= point->z_ss ==> zeta + \result <= point->z_ss;
    // Lemma 1: below z_ss the deflection changes by between nothing and the displacement, and
    // strictly: Theorem 2
    ensures zeta < point->z_ss ==> 0 < \result <= counts * c->unit;
    // Case 1: strictly towards z_ss, and not beyond
    ensures zeta > point->z_ss ==> point->z_ss <= zeta + \result < zeta;
    ensures zeta == point->z_ss ==> \result == 0;
    // Lemma 2: plastic displacement has the direction of the motion, and needs more than z_ba
    ensures counts * c->unit - \result >= 0;
    ensures counts * c->unit - \result > 0 ==> zeta + \result > c->z_ba;
    // The elastic identity, to the unit: no drift
    ensures zeta + counts * c->unit <= c->z_ba ==> \result == counts * c->unit;
    // Theorem 2: a displacement of 2 z_max arrives at once
    ensures counts * c->unit >= 2 * c->z_max ==> zeta + \result == point->z_ss;
*/
static IN_LINE int32_t deflection(const coeffs_t *c, const point_t *point, int32_t zeta,
                                  uint32_t counts)
{
    const int32_t gap = point->z_ss - zeta;
    const int32_t room = c->z_ba - zeta;
    /*@ assert counts < c->leap ==> counts * c->unit <= (c->leap - 1) * c->unit; */
    /*@ assert counts >= c->leap ==> counts * c->unit >= c->leap * c->unit; */
    if (counts >= c->leap) {
        return gap; /* a displacement of 2 z_max */
    }
    const int32_t d = (int32_t)(counts * c->unit);
    /*@ assert d == counts * c->unit && 0 < d; */
    if (d <= room) {
        return d; /* all elastic */
    }
    return rule_in_use(c->update) == EPF_UPDATE_SATURATED ? saturated_rule(point, room, gap, d)
                                                          : mean_value_rule(point, room, gap, d);
}
