/* SPDX-License-Identifier: MIT */
/* EPF_UPDATE_SATURATED: the update rule of the paper, eqs. (12) and (13). Included by update.h. */

/* dzeta for a displacement d that is not all elastic; the room for such a one is z_ba - zeta, the gap
   z_ss - zeta */
/*@ requires \valid_read(point) && valid_span(point);
    requires room < gap && room < d && 0 < d;
    assigns \nothing;
    ensures 0 < gap ==> 0 < \result <= d && \result <= gap && room < \result;
    ensures gap <= 0 ==> \result == gap;
*/
static LEAF int32_t saturated_rule(const coeffs_t *c, const point_t *point, int32_t zeta, int32_t d)
{
    const int32_t gap = point->z_ss - zeta;
    if (gap <= 0) {
        return gap; /* case 1 */
    }
    return saturated(
        zeta > c->z_ba ? deflecting_part(point, share_of_span(point, (uint32_t)gap), d) : d, gap);
}
