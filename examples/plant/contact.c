/* SPDX-License-Identifier: MIT */
#include "contact.h"

#include <math.h>

/* alpha(z, v), and |z_ss(v)| with it */
static double alpha(const contact_t *contact, double z, double v, double *z_ss)
{
    const friction_t *p = &contact->friction;
    if (contact->model == CONTACT_DAHL) {
        *z_ss = p->f_c / p->sigma_0;
        return 1.0;
    }
    *z_ss = friction_z_ss(p, v);
    return contact->model == CONTACT_LUGRE ? 1.0 : friction_alpha(p, v < 0.0 ? -z : z, *z_ss);
}

double contact_rate(const contact_t *contact, double z, double v)
{
    if (contact->model == CONTACT_COULOMB) {
        return 0.0;
    }
    double z_ss = 0.0;
    const double share = alpha(contact, z, v, &z_ss);
    return v - share * fabs(v) * z / z_ss;
}

double contact_force(const contact_t *contact, double z, double v)
{
    const friction_t *p = &contact->friction;
    switch (contact->model) {
    case CONTACT_COULOMB:
        return (v == 0.0 ? 0.0 : copysign(p->f_c, v)) + p->sigma_2 * v;
    case CONTACT_DAHL:
        return p->sigma_0 * z + p->sigma_2 * v;
    case CONTACT_ELASTO_PLASTIC:
    case CONTACT_LUGRE:
    default:
        return p->sigma_0 * z + p->sigma_1 * contact_rate(contact, z, v) + p->sigma_2 * v;
    }
}

double contact_energy(const contact_t *contact, double z)
{
    return contact->friction.sigma_0 * z * z / 2.0;
}
