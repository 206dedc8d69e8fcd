/* SPDX-License-Identifier: MIT */
/*
 * EPF_UPDATE_MEAN_VALUE. By the mean value theorem the exact dzeta is what eq. (12) gives at some deflection
 * inside the step. This rule guesses that deflection, and takes eq. (12) there. tests/proof/README.md
 * says why the theorems hold, examples/figures/README.md how close it comes. Included by update.h.
 *
 * All quantities are fractions. With the span S = z_ss - z_ba a gap z_ss - zeta is told as its share u or
 * w of the span; r is S/z_ss, and p a quarter of d/S.
 */

#define THIRTY_SECONDS(n) ((fraction_t)((n) * (ONE / 32u + 1u)))

/* 1 - v + 5/8 v^2: near the root of (1 - exp(-4 v))/(4 v), the mean of an exponential over a step */
/*@ assigns \nothing; */
static inline fraction_t mean_root(fraction_t v)
{
    return ONE - product(v, ONE - product(v, THIRTY_SECONDS(20u)));
}

/* The share of the span that the gap has where to take eq. (12), for a displacement of 4 p S that begins
   at the share u. What happens until there is estimated with w b for 1 - alpha, b = w (11/4 - 13/8 w), so
   that the gap closes at the rate b + r (1 - w b) = r + b (1 - w r). A quarter of these fits a fraction. */
/*@ assigns \nothing; */
static IN_LINE fraction_t mean_share(fraction_t u, fraction_t p, fraction_t r)
{
    const fraction_t w = u - product(u, (fraction_t)(p + p / 4u));
    const fraction_t quarter_b = product(w, THIRTY_SECONDS(22u) - product(w, THIRTY_SECONDS(13u)));
    const fraction_t quarter_rate = (fraction_t)(r / 4u + product(quarter_b, ONE - product(w, r)));
    const fraction_t h = mean_root((fraction_t)(4u * product(p, quarter_rate)));
    return product(u, product(h, h));
}

/* dzeta from zeta >= z_ba, by the gap z_ss - zeta */
/*@ requires valid_coeffs(c) && \valid_read(point) && valid_point(c, point);
    requires 0 < gap <= point->z_ss - c->z_ba && 0 < d;
    assigns \nothing;
    ensures 0 < \result <= d && \result <= gap;
*/
static IN_LINE int32_t approached(const coeffs_t *c, const point_t *point, int32_t gap, int32_t d)
{
    const uint32_t quarter = (uint32_t)d / 4u;
    const uint32_t most = (uint32_t)(point->z_ss - c->z_ba) / 8u * 5u; /* for p up to 5/8 */
    const fraction_t p = share_of_span(point, quarter < most ? quarter : most);
    const fraction_t u = share_of_span(point, (uint32_t)gap - 1u); /* no fraction is 1 */
    return within_gap(deflecting_part(point, mean_share(u, p, point->span_share), d), gap);
}

/* -dzeta from above z_ss: near 1 - exp(-q) of the excess zeta - z_ss, q = d/z_ss; all of it from 2.7 on */
/*@ requires 0 < z_ss < STATE_LIMIT && 0 <= excess < STATE_LIMIT && 0 < d;
    assigns \nothing;
    ensures 0 <= \result <= excess;
    ensures 0 < excess ==> 0 < \result;
*/
static IN_LINE int32_t let_go(int32_t z_ss, int32_t excess, int32_t d)
{
    if (d / 4 >= z_ss - z_ss / 8) {
        return excess; /* q/4 >= 7/8, where all goes; below that it is a fraction */
    }
    const uint32_t v = quarter_of_ratio((uint32_t)d, (uint32_t)z_ss);
    const fraction_t h = mean_root(leading(v));
    const uint32_t slowed = part(4u * (uint32_t)excess, product(h, h));
    return relaxed(fine_part(slowed, v), excess); /* of q h^2 of it, q = 4 v */
}

/* dzeta for a displacement that leads beyond z_ba, short of 2 z_max: up to z_ba all of it, then a part */
/*@ requires valid_coeffs(c) && \valid_read(point) && valid_point(c, point);
    requires -c->z_max <= zeta <= c->z_max && c->z_ba < zeta + d && 0 < d;
    assigns \nothing;
    ensures is_step(c->z_ba, point->z_ss, zeta, d, \result);
*/
static LEAF int32_t mean_value_rule(const coeffs_t *c, const point_t *point, int32_t zeta,
                                    int32_t d)
{
    const int32_t gap = point->z_ss - zeta;
    const int32_t room = c->z_ba - zeta;
    if (gap <= 0) {
        return -let_go(point->z_ss, -gap, d); /* case 1 */
    }
    const int32_t elastic = room > 0 ? room : 0;
    return elastic + approached(c, point, gap - elastic, d - elastic);
}
