/* SPDX-License-Identifier: MIT */
/* EPF_UPDATE_MEAN_VALUE in floats; mean_value.h has it in integers, and says what it is. Included by f32.c. */

/* 1 - v + 5/8 v^2: near the root of (1 - exp(-4 v))/(4 v), the mean of an exponential over a step */
static inline float mean_root(float v)
{
    return (1.0f - v) + 0.625f * (v * v);
}

/* The share of the span that the gap has where to take eq. (12) */
static inline float mean_share(float u, float p, float r)
{
    const float w = u - (1.25f * u) * p;
    const float b = w * (2.75f - 1.625f * w);
    const float h = mean_root(p * (r + b * (1.0f - r * w)));
    return u * (h * h);
}

/* dzeta below z_ss: all of d as far as there is room for it up to z_ba, then a part of the rest */
static inline float mean_value(const epf_f32_point_t *point, float z_ba, float room, float gap,
                               float d)
{
    const float rest = d - positive_part(room);
    const float elastic = d - rest; /* exactly */
    const float r = (point->z_ss - z_ba) * point->inv_z_ss;
    const float u = at_most(gap * point->inv_span, 1.0f); /* where the rest begins */
    const float p = at_most(rest * (0.25f * point->inv_span), 0.625f);
    const float w = mean_share(u, p, r);
    const float part = (r * w) * rest; /* (1 - zeta/z_ss) dx */
    return elastic + (part + elastic_share(w) * (rest - part));
}

/* dzeta above z_ss, where the gap is negative: near 1 - exp(-q) of it, q = d/z_ss */
static inline float let_go(const epf_f32_point_t *point, float gap, float d)
{
    const float q = at_most(d * point->inv_z_ss, 4.0f);
    const float h = mean_root(0.25f * q);
    return gap * (q * (h * h));
}
