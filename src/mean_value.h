/* SPDX-License-Identifier: MIT */
/*
 * EPF_UPDATE_MEAN_VALUE. By the mean value theorem dzeta is exactly what eq. (12) gives at some deflection
 * inside the step. This rule guesses that deflection, and takes eq. (12) there. tests/proof/README.md
 * says why the theorems hold, examples/figures/README.md how close it comes. Included by update.h.
 *
 * With the span S = z_ss - z_ba, u = gap/S where the step begins, and r = S/z_ss. Fractions all.
 */

#define EIGHTHS(n)        ((fraction_t)(ONE / 8u * (n)))
#define THIRTY_SECONDS(n) ((fraction_t)(ONE / 32u * (n)))

/* 1 - v + 5/8 v^2: near the root of (1 - exp(-4 v))/(4 v), the mean of an exponential over a step */
/*@ assigns \nothing; */
static inline fraction_t mean_root(fraction_t v)
{
    return (fraction_t)(ONE - product(v, (fraction_t)(ONE - product(v, EIGHTHS(5)))));
}

/* The deflection at which to take eq. (12), as its share w = (z_ss - zeta)/S of the span. For what the
   displacement does until there a rough 1 - alpha is enough, the polynomial b. */
/*@ requires \valid_read(point) && valid_span(point);
    requires 0 < gap && 0 < d && 0 < span;
    assigns \nothing;
*/
static LEAF fraction_t mean_share(const point_t *point, int32_t span, int32_t gap, int32_t d)
{
    const uint32_t quarter = (uint32_t)d / 4u, most = (uint32_t)span / 8u * 5u;
    const fraction_t p =
        share_of_span(point, quarter < most ? quarter : most); /* d/(4 S), at most 5/8 */
    const fraction_t u =
        share_of_span(point, (uint32_t)gap - 1u); /* where it is the span, below 1 */
    const fraction_t r = point->span_share;
    const fraction_t w = (fraction_t)(u - product(u, (fraction_t)(p + p / 4u)));
    const fraction_t b = product(
        w, (fraction_t)(THIRTY_SECONDS(22) -
                        product(w, THIRTY_SECONDS(13)))); /* w (11/4 - 13/8 w), a quarter of it */
    const fraction_t rate =
        (fraction_t)(r / 4u +
                     product(b, (fraction_t)(ONE - product(w, r)))); /* (b + r (1 - w b))/4 */
    const fraction_t h = mean_root((fraction_t)(4u * product(p, rate)));
    return product(u, product(h, h));
}

/* How much of the excess zeta - z_ss a displacement lets go: near 1 - exp(-q) of it, q = d/z_ss */
/*@ requires 0 < z_ss < STATE_LIMIT && 0 <= excess < STATE_LIMIT && 0 < d;
    assigns \nothing;
    ensures 0 <= \result <= excess;
    ensures 0 < excess ==> 0 < \result;
*/
static LEAF int32_t let_go(int32_t z_ss, int32_t excess, int32_t d)
{
    if (d / 4 >= z_ss) {
        return excess;
    }
    const uint32_t v = quarter_of_ratio((uint32_t)d, (uint32_t)z_ss); /* q/4 */
    const fraction_t h = mean_root(leading(v));
    const uint32_t slowed = part(4u * (uint32_t)excess, product(h, h));
    return relaxed(fine_part(slowed, v), excess); /* q h^2 of it */
}

/* dzeta for a displacement d that is not all elastic; the room for such a one is z_ba - zeta, the gap
   z_ss - zeta */
/*@ requires \valid_read(point) && valid_span(point) && 0 < point->z_ss < STATE_LIMIT;
    requires room < gap && room < d && 0 < d;
    requires -STATE_LIMIT < gap;
    requires gap - room < STATE_LIMIT;
    assigns \nothing;
    ensures 0 < gap ==> 0 < \result <= d && \result <= gap && room < \result;
    ensures gap <= 0 ==> gap <= \result <= 0;
    ensures gap < 0 ==> \result < 0;
*/
static OUT_OF_LINE int32_t mean_value_rule(const point_t *point, int32_t room, int32_t gap,
                                           int32_t d)
{
    if (gap <= 0) {
        return -let_go(point->z_ss, -gap, d); /* case 1 */
    }
    const int32_t elastic = room > 0 ? room : 0;
    const int32_t rest = d - elastic, rest_of_gap = gap - elastic;
    const fraction_t w = mean_share(point, gap - room, rest_of_gap, rest);
    return elastic + saturated(deflecting_part(point, w, rest), rest_of_gap);
}
