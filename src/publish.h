/* SPDX-License-Identifier: MIT */
/*
 * What one context hands to another: the operating point, to one that may preempt it while it writes,
 * and the force. Included by q31.c and q15.c after point_t and contact_t.
 */

/*@ requires \valid_read(ep) && ep->published <= 1;
    assigns \result \from ep, ep->published;
    ensures \result == &ep->points[ep->published];
*/
static inline const point_t *published_point(const contact_t *ep)
{
    return *(const volatile uint8_t *)&ep->published == 0 ? &ep->points[0] : &ep->points[1];
}

/* The other one, for the velocity context to write */
/*@ requires \valid(ep) && ep->published <= 1;
    assigns \result \from ep, ep->published;
    ensures \result == &ep->points[1 - ep->published];
*/
static inline point_t *point_aside(contact_t *ep)
{
    return ep->published == 0 ? &ep->points[1] : &ep->points[0];
}

/* Announces it by one store. Volatile accesses keep their order, and a point is written by such. */
/*@ requires \valid(ep) && ep->published <= 1;
    assigns ep->published;
    ensures ep->published == 1 - \old(ep->published);
*/
static inline void publish_point(contact_t *ep)
{
    *(volatile uint8_t *)&ep->published = (uint8_t)(1u - ep->published);
}

/*@ requires \valid(ep);
    assigns ep->force;
    ensures ep->force == force;
*/
static inline void publish_force(contact_t *ep, signal_t force)
{
    *(volatile signal_t *)&ep->force = force;
}

/*@ requires \valid_read(ep);
    assigns \nothing;
    ensures \result == ep->force;
*/
static inline signal_t published_force(const contact_t *ep)
{
    return *(const volatile signal_t *)&ep->force;
}
