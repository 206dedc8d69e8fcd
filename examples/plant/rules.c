/* SPDX-License-Identifier: MIT */
#include "rules.h"

#include "contact.h"

#include <math.h>

static double euler(contact_model_t model, const friction_t *p, double z, double v, double dt)
{
    const contact_t contact = {*p, model};
    return z + dt * contact_rate(&contact, z, v);
}

double rule_lugre_euler(const friction_t *p, double z, double dx, double v, double dt)
{
    (void)dx;
    return euler(CONTACT_LUGRE, p, z, v, dt);
}

double rule_elasto_plastic_euler(const friction_t *p, double z, double dx, double v, double dt)
{
    (void)dx;
    return euler(CONTACT_ELASTO_PLASTIC, p, z, v, dt);
}

double rule_lugre_exact(const friction_t *p, double z, double dx, double v, double dt)
{
    (void)dx;
    const double z_ss = copysign(friction_z_ss(p, v), v);
    return z_ss + (z - z_ss) * exp(-fabs(v) * dt / fabs(z_ss));
}

/* ---- Algorithm 1 as printed ----------------------------------------------------------------- */

/* z_ss has the sign of v, which the comparison and the sine were not made for */
static double printed_alpha(const friction_t *p, double z, double v, double z_ss)
{
    if (z * v < 0.0 || fabs(z) <= p->z_ba) {
        return 0.0;
    }
    return friction_alpha(p, fabs(z), z_ss);
}

double rule_algorithm_1_as_printed(const friction_t *p, double z, double dx, double v, double dt)
{
    (void)dt;
    const double z_ss = friction_f_ss(p, v) / p->sigma_0; /* 0 for v = 0 */
    if (z * v > 0.0 && fabs(z) >= fabs(z_ss)) {
        return z_ss; /* case 1 */
    }
    const double moved = z + (1.0 - printed_alpha(p, z, v, z_ss) * z / z_ss) * dx;
    return moved * v > 0.0 && fabs(moved) >= fabs(z_ss) ? z_ss : moved; /* (13) */
}

/* ---- the exact flow, along the motion: zeta from its start over the way d -------------------- */

/* Between z_ba and z_ss, in steps of Runge-Kutta's fourth-order rule, short beside z_ss - z_ba */
enum { FLOW_STEPS_PER_SPAN = 64 };

static double flow_slope(const friction_t *p, double zeta, double z_ss)
{
    return 1.0 - friction_alpha(p, zeta, z_ss) * zeta / z_ss;
}

static double flow_step(const friction_t *p, double zeta, double h, double z_ss)
{
    const double k1 = flow_slope(p, zeta, z_ss);
    const double k2 = flow_slope(p, zeta + h / 2.0 * k1, z_ss);
    const double k3 = flow_slope(p, zeta + h / 2.0 * k2, z_ss);
    const double k4 = flow_slope(p, zeta + h * k3, z_ss);
    return zeta + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
}

static double mixed_flow(const friction_t *p, double zeta, double d, double z_ss)
{
    const double longest = (z_ss - p->z_ba) / FLOW_STEPS_PER_SPAN;
    while (d > 0.0 && z_ss - zeta > 1e-12 * z_ss) {
        const double h = fmin(d, longest);
        zeta = flow_step(p, zeta, h, z_ss);
        d -= h;
    }
    return zeta;
}

double rule_exact_flow(const friction_t *p, double z, double dx, double v, double dt)
{
    (void)dt;
    const double s = dx < 0.0 ? -1.0 : 1.0;
    const double z_ss = friction_z_ss(p, v);
    const double d = fabs(dx);
    const double zeta = s * z;
    if (zeta >= z_ss) { /* alpha is 1: an exponential */
        return s * (z_ss + (zeta - z_ss) * exp(-d / z_ss));
    }
    const double elastic = fmin(d, fmax(p->z_ba - zeta, 0.0));
    return s * mixed_flow(p, zeta + elastic, d - elastic, z_ss);
}
