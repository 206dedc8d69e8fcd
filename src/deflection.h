/* SPDX-License-Identifier: MIT */
/* The additive core of f32: z as an unevaluated sum of two floats. A file of its own, for a test takes it
   through every case of a format so small that there is an end of them; hence also C++. */
#ifndef EPF_DEFLECTION_H
#define EPF_DEFLECTION_H

/* high + low, |low| <= ulp(high)/2 */
typedef struct {
    float high, low;
} deflection_t;

/* z + y, exact to 48 bits (Knuth's two-sum); odd, and never less than z for y >= 0 */
static inline deflection_t sum_of(deflection_t z, float y)
{
    const float sum = z.high + y;
    const float y_seen = sum - z.high;
    const float lost = (z.high - (sum - y_seen)) + (y - y_seen);
    const float low = z.low + lost;
    const float high = sum + low;
    const deflection_t result = {high, low - (high - sum)};
    return result;
}

/* z_ss - zeta, where zeta = s z: positive if and only if zeta < z_ss. A y below it, of the sign s, does
   not carry z + y beyond z_ss. */
static inline float gap_of(deflection_t z, float s, float z_ss)
{
    return (z_ss - s * z.high) - s * z.low;
}

#endif
