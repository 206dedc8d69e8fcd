/* SPDX-License-Identifier: MIT */
/* EPF_UPDATE_SATURATED: the update rule of the paper, eqs. (12) and (13). Included by update.h. */

/* dzeta for a displacement that leads beyond z_ba */
/*@ requires valid_coeffs(c) && \valid_read(point) && valid_point(c, point);
    requires -c->z_max <= zeta <= c->z_max && c->z_ba < zeta + d && 0 < d;
    assigns \nothing;
    ensures is_step(c->z_ba, point->z_ss, zeta, d, \result);
    ensures zeta > point->z_ss ==> zeta + \result == point->z_ss;
*/
static LEAF int32_t saturated_rule(const coeffs_t *c, const point_t *point, int32_t zeta, int32_t d)
{
    const int32_t gap = point->z_ss - zeta;
    if (gap <= 0) {
        return gap; /* case 1 */
    }
    if (zeta <= c->z_ba) {
        return within_gap(d, gap);
    }
    return within_gap(deflecting_part(point, share_of_span(point, (uint32_t)gap), d), gap);
}
