/* SPDX-License-Identifier: MIT */
#include "oracle.h"

#include <math.h>

static const double pi = 3.14159265358979323846;

static double sgn(double x)
{
    return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0;
}

double oracle_fss(const epf_params_t *p, double v)
{
    const double f_c = (double)p->f_c;
    const double excess = (double)p->f_max - f_c;
    const double ratio = v / (double)p->v_s;
    switch (p->stribeck) {
    case EPF_STRIBECK_COULOMB:
        return f_c * sgn(v);
    case EPF_STRIBECK_GAUSSIAN:
        return (excess * exp(-ratio * ratio) + f_c) * sgn(v);
    case EPF_STRIBECK_LORENTZIAN:
        break;
    }
    return (excess / (1.0 + ratio * ratio) + f_c) * sgn(v);
}

double oracle_zss(const epf_params_t *p, double v)
{
    return (v != 0.0 ? oracle_fss(p, v) : (double)p->f_max) / (double)p->sigma_0;
}

/* alpha where z_ss, of the sign of the motion, is known */
static double alpha_at(const epf_params_t *p, double z, double z_ss)
{
    const double z_ba = (double)p->z_ba;
    if (sgn(z) != sgn(z_ss) || fabs(z) <= z_ba) {
        return 0.0;
    }
    if (fabs(z) >= fabs(z_ss)) {
        return 1.0;
    }
    const double middle = (fabs(z_ss) + z_ba) / 2.0;
    return 0.5 + 0.5 * sin(pi * (fabs(z) - middle) / (fabs(z_ss) - z_ba));
}

double oracle_alpha(const epf_params_t *p, double z, double v)
{
    return v == 0.0 ? 0.0 : alpha_at(p, z, oracle_zss(p, v));
}

static double along(double dx, double v)
{
    return sgn(dx) * fabs(v);
}

static double motion_zss(const epf_params_t *p, double dx, double v)
{
    return sgn(dx) * fabs(oracle_zss(p, v));
}

double oracle_update(const epf_params_t *p, double z, double dx, double v)
{
    if (dx == 0.0) {
        return z;
    }
    const double z_ss = motion_zss(p, dx, v);
    if (sgn(z) == sgn(z_ss) && fabs(z) >= fabs(z_ss)) {
        return z_ss;
    }
    const double next = z + dx * (1.0 - alpha_at(p, z, z_ss) * z / z_ss);
    return (next - z_ss) * sgn(dx) > 0.0 ? z_ss : next;
}

/* 1 - v + 5/8 v^2 */
static double mean_root(double v)
{
    return 1.0 - v + 0.625 * v * v;
}

/* From above z_ss, zeta towards z_ss = zs > 0 */
static double mean_value_above(double zeta, double d, double zs)
{
    const double q = d / zs;
    const double h = mean_root(fmin(q, 4.0) / 4.0);
    return zs + (zeta - zs) * (1.0 - fmin(q * h * h, 1.0));
}

/* From z_ba <= zeta < z_ss */
static double mean_value_below(const epf_params_t *p, double zeta, double d, double zs)
{
    const double span = zs - (double)p->z_ba;
    const double u = (zs - zeta) / span;
    const double quarter = fmin(d / (4.0 * span), 5.0 / 8.0);
    const double w = u * (1.0 - 1.25 * quarter);
    const double b = w * (11.0 / 4.0 - 13.0 / 8.0 * w);
    const double v = quarter * (b + span / zs * (1.0 - w * b));
    const double zeta_m = zs - (zs - zeta) * mean_root(v) * mean_root(v);
    return fmin(zeta + d * (1.0 - alpha_at(p, zeta_m, zs) * zeta_m / zs), zs);
}

double oracle_mean_value(const epf_params_t *p, double z, double dx, double v)
{
    const double s = sgn(dx), zeta = s * z, d = fabs(dx);
    const double zs = fabs(oracle_zss(p, v));
    if (d >= 2.0 * (double)p->f_max / (double)p->sigma_0) {
        return s * zs;
    }
    const double elastic = fmin(d, fmax((double)p->z_ba - zeta, 0.0));
    if (elastic == d) {
        return z + dx;
    }
    return s * (zeta < zs ? mean_value_below(p, zeta + elastic, d - elastic, zs)
                          : mean_value_above(zeta, d, zs));
}

double oracle_force(const epf_params_t *p, double z_before, double z, double dx, double v,
                    double dt)
{
    return (double)p->sigma_0 * z + (double)p->sigma_1 * (z - z_before) / dt +
           (double)p->sigma_2 * (dx != 0.0 ? along(dx, v) : v);
}

double oracle_guarded_force(const epf_params_t *p, double z_before, double z, double dx, double v,
                            double dt)
{
    const double rest =
        (double)p->sigma_0 * z + (double)p->sigma_2 * (dx != 0.0 ? along(dx, v) : v);
    const double damping = (double)p->sigma_1 * (z - z_before) / dt;
    if ((z - z_before) * dx >= 0.0) {
        return rest + damping;
    }
    const double bound = (1.0 - 1.0 / 1024.0) * fabs(rest);
    return rest + fmax(-bound, fmin(bound, damping));
}

double oracle_continuous(const epf_params_t *p, double z, double dx, double v, unsigned steps)
{
    const double h = dx / steps;
    const double z_ss = motion_zss(p, dx, v);
    for (unsigned i = 0; i < steps; i++) {
        const double k1 = 1.0 - alpha_at(p, z, z_ss) * z / z_ss;
        const double z2 = z + h / 2.0 * k1;
        const double k2 = 1.0 - alpha_at(p, z2, z_ss) * z2 / z_ss;
        const double z3 = z + h / 2.0 * k2;
        const double k3 = 1.0 - alpha_at(p, z3, z_ss) * z3 / z_ss;
        const double z4 = z + h * k3;
        const double k4 = 1.0 - alpha_at(p, z4, z_ss) * z4 / z_ss;
        z += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    }
    return z;
}
