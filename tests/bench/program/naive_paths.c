/* SPDX-License-Identifier: MIT */
/* The transcription on the same paths; and that it is no strawman: where the input is a number it
   comes to the same deflection as epf_f32. */
#include "naive.h"
#include "paths.h"
#include "run.h"

#include <epf/f32.h>

#include <math.h>

static epf_params_t params;
static int disagreements;

static float deflection_by_epf(motion_t by)
{
    epf_f32_coeffs_t coeffs;
    epf_f32_t contact;
    (void)epf_f32_coeffs_init(&coeffs, &params);
    epf_f32_init(&contact, &coeffs);
    epf_f32_reset(&contact, by.z);
    return epf_f32_update(&contact, by.dx, by.v);
}

static void measure(motion_t by)
{
    const float z_max = params.f_max / params.sigma_0;
    naive_t contact = {&params, by.z};
    (void)naive_step(&contact, by.dx, by.v, by.dt);

    if (isfinite(by.z) && isfinite(by.dx) && !isnan(by.v) &&
        !(fabsf(contact.z - deflection_by_epf(by)) <= 1e-5f * z_max)) {
        disagreements++;
    }
}

static void measure_contact(const contact_t *contact)
{
    params = contact->params;
    every_path(contact, measure);
}

int run(void)
{
    every_form(ordinary_contact, measure_contact);
    return disagreements;
}
