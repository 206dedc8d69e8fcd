/* SPDX-License-Identifier: MIT */
/*
 * One contact on integers: eqs. (9) and (12) to (14), and the public functions, for both fixed-point
 * variants. Included by q31.c and by q15.c after the arithmetic of the variant, whose functions it calls:
 *
 *     product(a, b), part(x, a)            of two fractions; of an integer and a fraction
 *     stribeck_weight(c, speed)            eqs. (6) to (8), without f_c
 *     viscous_term(c, speed)               sigma_2 |v|
 *     prepare(c, z_ss, viscous, point)     fills in what the update needs so that it need not divide
 *     share_of_span(point, gap)            (z_ss - zeta)/(z_ss - z_ba)
 *     half_sine(w)                         eq. (10)
 *     zeros_of_time, inverse_of_time(dt)   1/dt
 *     in_lsb(c, z, terms)                  the force in lsb.f
 *
 * With s = sgn dx_k: zeta = s z_{k-1}, zeta' = s z_k, d = |dx| > 0, dzeta = zeta' - zeta, dw = d - dzeta.
 */
#include "guard.h"

/* ---- steady state: eq. (9) ------------------------------------------------------------------ */

/* |z_ss(v)| for |v| > 0 */
/*@ requires valid_coeffs(c);
    requires 0 < speed <= SIGNAL_MAX + 1;
    assigns \nothing;
    ensures c->z_c <= \result <= c->z_max;
*/
static LEAF int32_t steady_state(const coeffs_t *c, uint32_t speed)
{
    return c->z_c + (int32_t)part((uint32_t)(c->z_max - c->z_c), stribeck_weight(c, speed));
}

/* All that follows from the velocity, written aside and then published */
/*@ requires valid_body(ep);
    assigns ep->points[0 .. 1], ep->published;
    assigns \result \from ep, ep->published;
    ensures valid_contact(ep);
    ensures \result == &ep->points[ep->published];
*/
static IN_LINE const point_t *set_point(contact_t *ep, signal_t v)
{
    const coeffs_t *c = ep->coeffs;
    int32_t z_ss = c->z_max;
    int32_t viscous = 0;
    if (v != 0) {
        const uint32_t speed = magnitude(v);
        z_ss = steady_state(c, speed);
        viscous = (int32_t)viscous_term(c, speed);
        viscous = v < 0 ? -viscous : viscous;
    }
    point_t *aside = point_aside(ep);
    prepare(c, z_ss, viscous, aside);
    /*@ assert valid_body(ep); */
    /*@ assert valid_point(ep->coeffs, aside); */
    publish_point(ep);
    /*@ assert valid_body(ep); */
    /*@ assert aside == &ep->points[ep->published]; */
    return aside;
}

/* ---- the state: eqs. (12) and (13) ---------------------------------------------------------- */

#include "update.h"

/* The state after a displacement */
/*@ requires valid_body(ep) && \valid_read(point) && valid_point(ep->coeffs, point);
    assigns ep->z, ep->dzeta, ep->direction;
    // Theorem 1: the state is bounded
    ensures valid_motion(ep->coeffs, ep->z, ep->dzeta, ep->direction);
    ensures dx == 0 ==> ep->z == \old(ep->z);
*/
static IN_LINE void move(contact_t *ep, const point_t *point, signal_t dx)
{
    const int32_t s = sign(dx);
    ep->direction = (int8_t)s;
    int32_t dzeta = 0;
    if (s != 0) {
        dzeta = deflection(ep->coeffs, point, along(s, ep->z), magnitude(dx));
        ep->z += along(s, dzeta);
    }
    ep->dzeta = dzeta;
}

/* ---- the force: eq. (14) -------------------------------------------------------------------- */

/* |sigma_1 dz/dt| in units of 256 sigma_0 u, rounded down, at most TERM_MAX */
/*@ requires valid_coeffs(c);
    requires 0 < dt;
    assigns \nothing;
    ensures \result <= TERM_MAX;
*/
static LEAF uint32_t damping_term(const coeffs_t *c, uint32_t distance, duration_t dt)
{
    const int zeros = zeros_of_time(dt);
    const int shift = c->damping_shift + zeros;
    if (shift > 0) {
        if (distance >> (32 - shift) != 0) {
            return TERM_MAX; /* 2^29 at the least: of the factors below one is 1/2, one 1/4 or more */
        }
        distance <<= shift;
    }
    const uint32_t p = part(part(distance, c->damping), inverse_of_time(dt, zeros));
    const uint32_t term = shift < 0 ? shifted_down(p, -shift) : p;
    return term < TERM_MAX ? term : TERM_MAX;
}

/* The terms of (14) beyond sigma_0 z, signed, in units of 256 sigma_0 u */
/*@ requires valid_body(ep);
    requires -TERM_MAX <= viscous <= TERM_MAX && damping <= TERM_MAX;
    assigns \nothing;
    ensures -2 * TERM_MAX <= \result <= 2 * TERM_MAX;
    ensures ep->direction == 0 ==> \result == viscous;
    // Theorem 3 in case 1, in the signs of the signals
    ensures ep->dzeta < 0 ==> ep->direction * (ep->z + 256 * \result) > 0;
    // in the other cases both terms go along the motion
    ensures ep->dzeta >= 0 ==> ep->direction * \result >= 0;
*/
static IN_LINE int32_t dissipative_terms(const contact_t *ep, int32_t viscous, uint32_t damping)
{
    const int s = ep->direction;
    if (s == 0) {
        return viscous; /* v' = v */
    }
    const uint32_t along_motion = magnitude(viscous); /* v' = |v| sgn dx */
    return along(s, ep->dzeta < 0 ? guarded(along(s, ep->z), along_motion, damping)
                                  : (int32_t)(along_motion + damping));
}

/* A time of 0 is counted; the counter saturates, so that it never decreases */
/*@ requires \valid(ep);
    assigns ep->rejected;
    ensures ep->rejected >= \old(ep->rejected);
*/
static inline void count_rejected(contact_t *ep)
{
    if (ep->rejected != UINT16_MAX) {
        ep->rejected++;
    }
}

/* Publishes it, too */
/*@ requires valid_body(ep) && -TERM_MAX <= viscous <= TERM_MAX;
    assigns ep->force, ep->rejected;
    ensures -SIGNAL_MAX <= \result <= SIGNAL_MAX;
    ensures ep->force == \result;
*/
static IN_LINE signal_t make_force(contact_t *ep, int32_t viscous, duration_t dt)
{
    uint32_t damping = 0;
    if (dt != 0) {
        damping = damping_term(ep->coeffs, magnitude(ep->dzeta), dt);
    } else {
        count_rejected(ep);
    }
    const int32_t terms = dissipative_terms(ep, viscous, damping);
    const signal_t force = in_lsb(ep->coeffs, ep->z, terms); /* (14) */
    publish_force(ep, force);
    return force;
}

/* ---- the public functions ------------------------------------------------------------------- */

/*@ requires valid_contact(ep);
    assigns ep->z, ep->dzeta, ep->direction;
    // Theorem 1: the state is bounded, by every operating point
    ensures valid_contact(ep);
    ensures \result == ep->z;
    ensures dx == 0 ==> ep->z == \old(ep->z);
*/
int32_t EPF(advance)(contact_t *ep, signal_t dx)
{
    move(ep, published_point(ep), dx);
    return ep->z;
}

/*@ requires valid_body(ep);
    assigns ep->points[0 .. 1], ep->published;
    ensures valid_contact(ep);
*/
void EPF(set_velocity)(contact_t *ep, signal_t v)
{
    (void)set_point(ep, v);
}

/*@ requires valid_contact(ep);
    assigns ep->points[0 .. 1], ep->published, ep->z, ep->dzeta, ep->direction;
    ensures valid_contact(ep);
    ensures \result == ep->z;
*/
int32_t EPF(update)(contact_t *ep, signal_t dx, signal_t v)
{
    EPF(set_velocity)(ep, v);
    return EPF(advance)(ep, dx);
}

/*@ requires valid_contact(ep);
    assigns ep->force, ep->rejected;
    ensures valid_contact(ep);
    ensures -SIGNAL_MAX <= \result <= SIGNAL_MAX;
    ensures ep->force == \result;
*/
signal_t EPF(force)(contact_t *ep, duration_t dt)
{
    return make_force(ep, published_point(ep)->viscous, dt);
}

/*@ requires valid_contact(ep);
    assigns *ep;
    ensures valid_contact(ep);
    ensures -SIGNAL_MAX <= \result <= SIGNAL_MAX;
    ensures ep->force == \result;
*/
signal_t EPF(step)(contact_t *ep, signal_t dx, signal_t v, duration_t dt)
{
    const point_t *point = set_point(ep, v);
    move(ep, point, dx);
    /*@ assert valid_contact(ep); */
    return make_force(ep, point->viscous, dt);
}

/*@ requires \valid_read(ep);
    assigns \nothing;
    ensures \result == ep->force;
*/
signal_t EPF(output)(const contact_t *ep)
{
    return published_force(ep);
}

/*@ requires \valid_read(ep);
    assigns \nothing;
    ensures \result == ep->z;
*/
int32_t EPF(z)(const contact_t *ep)
{
    return *(const volatile int32_t *)&ep->z;
}

/*@ requires valid_coeffs(coeffs);
    assigns \nothing;
    ensures v > 0 ==> \result >= 0;
    ensures v == 0 ==> \result == 0;
    ensures v < 0 ==> \result <= 0;
*/
signal_t EPF(fss)(const coeffs_t *coeffs, signal_t v)
{
    if (v == 0) {
        return 0;
    }
    return (signal_t)along(sign(v), in_lsb(coeffs, steady_state(coeffs, magnitude(v)), 0));
}

/*@ requires valid_coeffs(c);
    assigns \nothing;
    ensures -c->z_max <= \result <= c->z_max;
    ensures -c->z_max <= z <= c->z_max ==> \result == z;
*/
static inline int32_t clamped_state(const coeffs_t *c, int32_t z)
{
    return z > c->z_max ? c->z_max : z < -c->z_max ? -c->z_max : z;
}

/*@ requires valid_coeffs(coeffs);
    assigns \nothing;
    ensures 0 <= \result <= STATE_LIMIT; // 0 to 1 in Q30
*/
int32_t EPF(alpha)(const coeffs_t *coeffs, int32_t z, signal_t v)
{
    const int32_t zeta = along(sign(v), clamped_state(coeffs, z));
    if (zeta <= coeffs->z_ba) {
        return 0;
    }
    point_t point;
    prepare(coeffs, steady_state(coeffs, magnitude(v)), 0, &point);
    const int32_t gap = point.z_ss - zeta;
    return gap > 0 ? in_q30(ONE - half_sine(share_of_span(&point, (uint32_t)gap))) : STATE_LIMIT;
}

/* A contact at rest: no displacement is left that a damping or viscous term could belong to */
/*@ requires \valid(ep);
    assigns ep->z, ep->dzeta, ep->direction, ep->force;
    ensures ep->z == z && ep->dzeta == 0 && ep->direction == 0 && ep->force == force;
*/
static inline void rest_at(contact_t *ep, int32_t z, signal_t force)
{
    ep->z = z;
    ep->dzeta = 0;
    ep->direction = 0;
    publish_force(ep, force);
}

/*@ requires \valid(ep) && valid_coeffs(coeffs) && \separated(ep, coeffs);
    assigns *ep;
    ensures valid_contact(ep);
    ensures ep->z == 0 && ep->coeffs == coeffs;
*/
void EPF(init)(contact_t *ep, const coeffs_t *coeffs)
{
    ep->coeffs = coeffs;
    ep->rejected = 0;
    ep->published = 0;
    rest_at(ep, 0, 0);
    (void)set_point(ep, 0);
}

/*@ requires valid_contact(ep);
    assigns ep->z, ep->dzeta, ep->direction, ep->force;
    ensures valid_contact(ep);
*/
void EPF(reset)(contact_t *ep, int32_t z)
{
    const int32_t clamped = clamped_state(ep->coeffs, z);
    rest_at(ep, clamped, in_lsb(ep->coeffs, clamped, 0));
}
