/* SPDX-License-Identifier: MIT */
/* The transcription and its rivals on the same paths; and that they are no strawmen: where the input is
   a number they come to the deflection that they should. */
#include "model.h"
#include "naive.h"
#include "paths.h"
#include "rivals.h"
#include "run.h"

#include <epf/f32.h>

#include <math.h>

static epf_params_t params;
static float z_max;
static int disagreements;

static void agree(float z, float other, float within)
{
    if (!(fabsf(z - other) <= within + 1e-5f * z_max)) {
        disagreements++;
    }
}

static float deflection_by_epf(motion_t by)
{
    epf_f32_coeffs_t coeffs;
    epf_f32_t contact;
    (void)epf_f32_coeffs_init(&coeffs, &params);
    epf_f32_init(&contact, &coeffs);
    epf_f32_reset(&contact, by.z);
    return epf_f32_update(&contact, by.dx, by.v);
}

static void measure_naive(motion_t by, int is_number)
{
    naive_t contact = {&params, by.z};
    (void)naive_step(&contact, by.dx, by.v, by.dt);
    if (is_number) {
        agree(contact.z, deflection_by_epf(by), 0.0f);
    }
}

/* Euler leaves out of exp(-q) = 1 - q + ... no more than q^2/2. */
static void measure_lugre(motion_t by, int is_number)
{
    naive_t by_euler = {&params, by.z}, exact = {&params, by.z};
    (void)lugre_euler_step(&by_euler, by.v, by.dt);
    (void)lugre_exact_step(&exact, by.v, by.dt);
    if (is_number) {
        const float z_ss = f_ss(&params, by.v) / params.sigma_0;
        const float q = fabsf(by.v) * by.dt / z_ss;
        agree(by_euler.z, exact.z, q * q / 2.0f * fabsf(by.z - copysignf(z_ss, by.v)));
    }
}

/* Below z_ss, what epf does with the displacement v dt, Euler does with the time dt. */
static void measure_ep(motion_t by, int is_number)
{
    naive_t by_euler = {&params, by.z};
    (void)ep_euler_step(&by_euler, by.v, by.dt);
    if (is_number) {
        const float z_ss = f_ss(&params, by.v) / params.sigma_0;
        const float z = deflection_by_epf((motion_t){by.z, by.v * by.dt, by.v, by.dt});
        if (fabsf(z) < (1.0f - 1e-5f) * z_ss) {
            agree(by_euler.z, z, 0.0f);
        }
    }
}

static void measure(motion_t by)
{
    measure_naive(by, isfinite(by.z) && isfinite(by.dx) && !isnan(by.v));
    measure_lugre(by, isfinite(by.z) && isfinite(by.v));
    measure_ep(by, isfinite(by.z) && isfinite(by.v));
}

static void measure_contact(const contact_t *contact)
{
    params = contact->params;
    z_max = params.f_max / params.sigma_0;
    every_path(contact, measure);
}

int run(void)
{
    every_form(EPF_UPDATE_SATURATED, ordinary_contacts, measure_contact);
    return disagreements;
}
