/* SPDX-License-Identifier: MIT */
/*
 * What the contracts of a fixed-point variant speak of. Included by q31.c and q15.c after coeffs_t,
 * point_t, contact_t, valid_leap(), valid_gains() and valid_span().
 */

/*@ // Coefficients as coeffs_init makes them
    predicate valid_coeffs(coeffs_t *c) =
      \valid_read(c) &&
      0 < c->z_ba < c->z_c <= c->z_max < STATE_LIMIT &&
      0 < c->unit && 0 < c->leap && valid_leap(c) && valid_gains(c);

    // An operating point of some velocity
    predicate valid_point(coeffs_t *c, point_t *p) =
      c->z_c <= p->z_ss <= c->z_max &&
      -TERM_MAX <= p->viscous <= TERM_MAX &&
      valid_span(p);

    // z_k, s (z_k - z_{k-1}) and s = sgn dx_k, as a step leaves them. Where the deflection shrinks
    // along the motion it was above z_ss, and is z_ss > 0 or above now.
    predicate valid_motion(coeffs_t *c, integer z, integer dzeta, integer direction) =
      -c->z_max <= z <= c->z_max &&
      -2 * c->z_max <= dzeta <= 2 * c->z_max &&
      -1 <= direction <= 1 &&
      (dzeta < 0 ==> direction * z > 0);

    // A contact, also before it has its first operating point
    predicate valid_body(contact_t *ep) =
      \valid(ep) && valid_coeffs(ep->coeffs) && \separated(ep, ep->coeffs) &&
      valid_motion(ep->coeffs, ep->z, ep->dzeta, ep->direction) && ep->published <= 1;

    // A contact from init on
    predicate valid_contact(contact_t *ep) =
      valid_body(ep) && valid_point(ep->coeffs, &ep->points[ep->published]);
*/
