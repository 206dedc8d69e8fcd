/* SPDX-License-Identifier: MIT */
/*
 * The functions of a fixed_variant_t, written once. Included by q31_variant.c and q15_variant.c after
 * the source of the variant, of which it uses the types and names, and after MEMBER, the member of the
 * unions that is the variant's.
 */
#include "fixed_variant.h"

#include <stddef.h>

/* ---- the public functions ------------------------------------------------------------------- */

static epf_status_t coeffs_init(any_coeffs_t *c, const epf_params_t *params, const epf_lsb_t *lsb)
{
    return EPF(coeffs_init)(c != NULL ? &c->MEMBER : NULL, params, lsb);
}

static void init(any_contact_t *ep, const any_coeffs_t *c)
{
    EPF(init)(&ep->MEMBER, &c->MEMBER);
}

static void reset(any_contact_t *ep, int32_t z)
{
    EPF(reset)(&ep->MEMBER, z);
}

static void set_velocity(any_contact_t *ep, int32_t v)
{
    EPF(set_velocity)(&ep->MEMBER, (signal_t)v);
}

static int32_t advance(any_contact_t *ep, int32_t dx)
{
    return EPF(advance)(&ep->MEMBER, (signal_t)dx);
}

static int32_t update(any_contact_t *ep, int32_t dx, int32_t v)
{
    return EPF(update)(&ep->MEMBER, (signal_t)dx, (signal_t)v);
}

static int32_t force(any_contact_t *ep, uint32_t dt)
{
    return EPF(force)(&ep->MEMBER, (duration_t)dt);
}

static int32_t step(any_contact_t *ep, int32_t dx, int32_t v, uint32_t dt)
{
    return EPF(step)(&ep->MEMBER, (signal_t)dx, (signal_t)v, (duration_t)dt);
}

static int32_t output(const any_contact_t *ep)
{
    return EPF(output)(&ep->MEMBER);
}

static int32_t state(const any_contact_t *ep)
{
    return EPF(z)(&ep->MEMBER);
}

static int32_t fss(const any_coeffs_t *c, int32_t v)
{
    return EPF(fss)(&c->MEMBER, (signal_t)v);
}

static int32_t alpha(const any_coeffs_t *c, int32_t z, int32_t v)
{
    return EPF(alpha)(&c->MEMBER, z, (signal_t)v);
}

/* ---- the fields ----------------------------------------------------------------------------- */

static fixed_lengths_t lengths(const any_coeffs_t *coeffs)
{
    const coeffs_t *c = &coeffs->MEMBER;
    return (fixed_lengths_t){c->z_max, c->z_c, c->z_ba, c->unit, c->leap, c->z_shift};
}

static bool same_coeffs(const any_coeffs_t *a, const any_coeffs_t *b)
{
    const coeffs_t *p = &a->MEMBER, *q = &b->MEMBER;
    return p->z_max == q->z_max && p->z_c == q->z_c && p->z_ba == q->z_ba && p->unit == q->unit &&
           p->leap == q->leap && p->damping == q->damping && p->damping_shift == q->damping_shift &&
           p->output == q->output && p->output_shift == q->output_shift &&
           p->z_shift == q->z_shift && p->stribeck == q->stribeck && p->update == q->update &&
           same_gains(p, q);
}

static bool same_point(const any_contact_t *a, const any_contact_t *b, int which)
{
    const point_t *p = &a->MEMBER.points[which], *q = &b->MEMBER.points[which];
    return p->z_ss == q->z_ss && p->viscous == q->viscous && p->span_inverse == q->span_inverse &&
           p->span_share == q->span_share && same_span(p, q);
}

static bool same_contact(const any_contact_t *a, const any_contact_t *b)
{
    const contact_t *p = &a->MEMBER, *q = &b->MEMBER;
    return p->coeffs == q->coeffs && p->z == q->z && p->dzeta == q->dzeta && p->force == q->force &&
           p->rejected == q->rejected && p->direction == q->direction &&
           p->published == q->published && same_point(a, b, 0) && same_point(a, b, 1);
}

static int published(const any_contact_t *ep)
{
    return ep->MEMBER.published;
}

static int32_t z_ss(const any_contact_t *ep)
{
    return published_point(&ep->MEMBER)->z_ss;
}

static int32_t viscous(const any_contact_t *ep)
{
    return published_point(&ep->MEMBER)->viscous;
}

static uint16_t *rejected(any_contact_t *ep)
{
    return &ep->MEMBER.rejected;
}

/* ---- inside --------------------------------------------------------------------------------- */

static uint32_t damping_of(const any_coeffs_t *c, uint32_t distance, uint32_t dt)
{
    return damping_term(&c->MEMBER, distance, (duration_t)dt);
}

static uint32_t viscous_of(const any_coeffs_t *c, uint32_t speed)
{
    return viscous_term(&c->MEMBER, speed);
}

static int32_t force_in_lsb(const any_coeffs_t *c, int32_t z, int32_t terms)
{
    return in_lsb(&c->MEMBER, z, terms);
}

static int64_t internal_force(const any_contact_t *contact, uint32_t dt)
{
    const contact_t *ep = &contact->MEMBER;
    const uint32_t damping =
        dt != 0 ? damping_term(ep->coeffs, magnitude(ep->dzeta), (duration_t)dt) : 0;
    return ep->z + 256 * (int64_t)dissipative_terms(ep, published_point(ep)->viscous, damping);
}

/* clang-format off */
#define VARIANT_FUNCTIONS                                                                          \
    .coeffs_init = coeffs_init, .init = init, .reset = reset, .set_velocity = set_velocity,        \
    .advance = advance, .update = update, .force = force, .step = step, .output = output,          \
    .z = state, .fss = fss, .alpha = alpha,                                                        \
    .lengths = lengths, .same_coeffs = same_coeffs, .same_contact = same_contact,                  \
    .same_point = same_point, .published = published, .z_ss = z_ss, .viscous = viscous,            \
    .rejected = rejected,                                                                          \
    .internal_force = internal_force, .damping_term = damping_of, .viscous_term = viscous_of,      \
    .in_lsb = force_in_lsb
/* clang-format on */
