/* SPDX-License-Identifier: MIT */
#include "rivals.h"

#include "model.h"

#include <math.h>

/* One step of explicit Euler by the rate dz/dt, and the force */
static float euler(naive_t *contact, float rate, float v, float dt)
{
    const epf_params_t *p = contact->params;
    contact->z += rate * dt;
    return p->sigma_0 * contact->z + p->sigma_1 * rate + p->sigma_2 * v;
}

float lugre_euler_step(naive_t *contact, float v, float dt)
{
    const float z_ss = f_ss(contact->params, v) / contact->params->sigma_0;
    return euler(contact, v - fabsf(v) * contact->z / z_ss, v, dt);
}

/* In a step of constant velocity z goes to z_ss sgn v like exp(-|v| t/z_ss) */
float lugre_exact_step(naive_t *contact, float v, float dt)
{
    const epf_params_t *p = contact->params;
    const float z_ss = f_ss(p, v) / p->sigma_0;
    const float z_end = copysignf(z_ss, v), z_before = contact->z;
    contact->z = z_end + (z_before - z_end) * expf(-fabsf(v) * dt / z_ss);
    return p->sigma_0 * contact->z + p->sigma_1 * (contact->z - z_before) / dt + p->sigma_2 * v;
}

float ep_euler_step(naive_t *contact, float v, float dt)
{
    const epf_params_t *p = contact->params;
    const float z_ss = f_ss(p, v) / p->sigma_0;
    const float zeta = v < 0.0f ? -contact->z : contact->z;
    const float rate = (1.0f - alpha(zeta, p->z_ba, z_ss) * zeta / z_ss) * v;
    return euler(contact, rate, v, dt);
}
