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

/* Writes the point aside, then announces it by one store. Volatile accesses keep their order. */
/*@ requires \valid(ep) && ep->published <= 1 && \valid_read(point) && \separated(ep, point);
    assigns ep->published, ep->points[0 .. 1];
    ensures ep->published == 1 - \old(ep->published);
    ensures ep->points[ep->published].z_ss == point->z_ss;
    ensures ep->points[ep->published].viscous == point->viscous;
    ensures ep->points[ep->published].span_zeros == point->span_zeros;
*/
static inline void publish_point(contact_t *ep, const point_t *point)
{
    const uint8_t aside = (uint8_t)(1u - ep->published);
    volatile point_t *target = &ep->points[aside];
    target->z_ss = point->z_ss;
    target->viscous = point->viscous;
    target->span_inverse = point->span_inverse;
    target->span_share = point->span_share;
    target->span_zeros = point->span_zeros;
    *(volatile uint8_t *)&ep->published = aside;
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
