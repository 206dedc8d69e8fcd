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
static IN_LINE int32_t saturated_rule(const point_t *point, int32_t room, int32_t gap, int32_t d)
{
    if (gap <= 0) {
        return gap; /* case 1 */
    }
    return saturated(room < 0 ? deflecting_part(point, share_of_span(point, (uint32_t)gap), d) : d,
                     gap);
}
