/* SPDX-License-Identifier: MIT */
#include "friction.h"

#include <math.h>

const friction_t friction_table_1 = {.sigma_0 = 1e5,
                                     .sigma_1 = 63.0,
                                     .sigma_2 = 0.0,
                                     .f_c = 1.0,
                                     .f_max = 1.1,
                                     .v_s = 1e-5,
                                     .z_ba = 8e-6, /* f_ba = 0.8 N */
                                     .form = FRICTION_LORENTZIAN};

const friction_t friction_table_2 = {.sigma_0 = 1e5,
                                     .sigma_1 = 1e3,
                                     .sigma_2 = 0.4,
                                     .f_c = 1.0,
                                     .f_max = 1.5,
                                     .v_s = 1e-3,
                                     .z_ba = 8e-6,
                                     .form = FRICTION_LORENTZIAN};

static const double pi = 3.14159265358979323846;

/* |f_ss(v)|, at rest its limit */
static double magnitude(const friction_t *p, double v)
{
    const double ratio = v / p->v_s;
    switch (p->form) {
    case FRICTION_COULOMB:
        return p->f_c;
    case FRICTION_GAUSSIAN:
        return (p->f_max - p->f_c) * exp(-ratio * ratio) + p->f_c;
    case FRICTION_LORENTZIAN:
    default:
        return (p->f_max - p->f_c) / (1.0 + ratio * ratio) + p->f_c;
    }
}

double friction_f_ss(const friction_t *p, double v)
{
    return v == 0.0 ? 0.0 : copysign(magnitude(p, v), v);
}

double friction_z_ss(const friction_t *p, double v)
{
    return v == 0.0 ? friction_z_max(p) : magnitude(p, v) / p->sigma_0;
}

double friction_z_max(const friction_t *p)
{
    return p->f_max / p->sigma_0;
}

double friction_alpha(const friction_t *p, double z_along, double z_ss)
{
    if (z_along <= p->z_ba) {
        return 0.0;
    }
    if (z_along >= z_ss) {
        return 1.0;
    }
    return 0.5 + 0.5 * sin(pi * ((z_along - p->z_ba) / (z_ss - p->z_ba) - 0.5));
}
