/* SPDX-License-Identifier: MIT */
/*
 * The theorems, in mathematical integers, on the shipped kernels of one variant: small functions that
 * put the kernels together as the library does, for every coefficient, velocity, state, displacement
 * and damping that there can be. EPF_VARIANT is "q31.c" or "q15.c".
 */
#include EPF_VARIANT

#ifdef EPF_Q15_H
#define VALID(c, point) (valid_point(c, *(point)) && short_inverses(*(point)))
#else
#define VALID(c, point) valid_point(c, *(point))
#endif

static int32_t zeta_after;

/*
 * The algebra of Theorem 4. With dz = zeta' - zeta and dw = d - dz, 2 d zeta' - (zeta'^2 - zeta^2) is
 * 2 zeta' dw + dz^2.
 */
/*@ requires 0 < d && 0 <= dw && dz + dw == d && zeta + dz == after;
    requires dz < 0 ==> f > 0 && after > 0;
    requires dz >= 0 ==> f >= after;
    requires dw > 0 ==> after > 0;
    requires -STATE_LIMIT < zeta < STATE_LIMIT && -STATE_LIMIT < after < STATE_LIMIT;
    assigns \nothing;
    ensures 2 * d * f > after * after - zeta * zeta;
*/
static void storage(int64_t d, int64_t dw, int64_t dz, int64_t f, int64_t zeta, int64_t after)
{
    /*@ assert after * after - zeta * zeta == 2 * after * dz - dz * dz; */
    /*@ assert 2 * d * after == 2 * dw * after + 2 * dz * after; */
    /*@ assert dw * after >= 0 && (dw > 0 ==> dw * after > 0); */
    /*@ assert dz >= 0 ==> d * f >= d * after; */
    /*@ assert dz < 0 ==> d * f > 0 && dz * after < 0; */
}

/* One displacement, d = counts 2^z_shift, and the force along it: f = zeta' + 2^8 rest */
/*@ requires valid_coeffs(c) && \valid_read(point) && VALID(c, point);
    requires \separated(&zeta_after, c, point);
    requires -c->z_max <= zeta <= c->z_max;
    requires 0 < counts <= 2147483648 && d == (counts << c->z_shift);
    requires d <= 1152921504606846976; // 2^31 counts of 2^29
    requires damping <= TERM_MAX;
    assigns zeta_after;

    // Theorem 3: plastic displacement dissipates, f dw > 0, for every sigma_1 and every dt
    ensures d - (zeta_after - zeta) != 0 ==> \result > 0;
    // Theorem 4: no step yields more energy than was stored, 2 f d > 2 (W_k - W_{k-1})
    ensures 2 * d * \result > zeta_after * zeta_after - zeta * zeta;
*/
static int64_t force_after(const epf_fixed_coeffs_t *c, const epf_fixed_point_t *point,
                           int32_t zeta, uint32_t counts, int64_t d, uint32_t damping)
{
    zeta_after = next_along(c, point, zeta, counts);
    const int32_t dzeta = zeta_after - zeta;
    const int32_t rest = rest_along(zeta_after, dzeta, magnitude(point->viscous), damping);
    const int64_t f = (int64_t)zeta_after + 256 * (int64_t)rest;
    storage(d, d - dzeta, dzeta, f, zeta, zeta_after);
    return f;
}

/*@ assigns \nothing;
    ensures 0 < \result <= 2147483648;
*/
uint32_t any_counts(void);

/*
 * Theorem 2: any displacements of at least one count lead to z_ss, exactly and in finitely many steps.
 */
/*@ requires valid_coeffs(c) && \valid_read(point) && VALID(c, point);
    requires -c->z_max <= zeta <= c->z_max;
    assigns \nothing;
    ensures \result == point->z_ss;
*/
static int32_t state_at_last(const epf_fixed_coeffs_t *c, const epf_fixed_point_t *point,
                             int32_t zeta)
{
    zeta = next_along(c, point, zeta, any_counts());
    /*@ loop invariant -c->z_max <= zeta <= point->z_ss;
        loop assigns zeta;
        loop variant point->z_ss - zeta;
    */
    while (zeta != point->z_ss) {
        zeta = next_along(c, point, zeta, any_counts());
    }
    return zeta;
}

/* No drift: there and back within z_ba ends where it began, to the unit */
/*@ requires valid_coeffs(c) && \valid_read(point) && VALID(c, point);
    requires 0 < counts <= 2147483648;
    requires -c->z_ba <= z && z + (counts << c->z_shift) <= c->z_ba;
    assigns \nothing;
    ensures \result == z;
*/
static int32_t there_and_back(const epf_fixed_coeffs_t *c, const epf_fixed_point_t *point,
                              int32_t z, uint32_t counts)
{
    const int32_t there = next_along(c, point, z, counts);
    return -next_along(c, point, -there, counts);
}
