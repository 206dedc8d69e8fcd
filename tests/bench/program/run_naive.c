/* SPDX-License-Identifier: MIT */
/* The transcription on the same paths; and that it is no strawman: where the input is a number it
   comes to the same deflection as epf_f32. */
#include "contact.h"
#include "naive.h"
#include "paths.h"
#include "run.h"

#include <epf/f32.h>

#include <math.h>

static epf_params_t params = {CONTACT(EPF_STRIBECK_LORENTZIAN)};
static int disagreements;

static float deflection_by_epf(float z, float dx, float v)
{
    epf_f32_coeffs_t coeffs;
    epf_f32_t contact;
    (void)epf_f32_coeffs_init(&coeffs, &params);
    epf_f32_init(&contact, &coeffs);
    epf_f32_reset(&contact, z);
    return epf_f32_update(&contact, dx, v);
}

static void measure(float z, float dx, float v, float dt)
{
    naive_t contact = {&params, z};
    (void)naive_step(&contact, dx, v, dt);

    if (isfinite(z) && isfinite(dx) &&
        !(fabsf(contact.z - deflection_by_epf(z, dx, v)) <= 1e-5f * Z_MAX)) {
        disagreements++;
    }
}

static void form_lorentzian(void)
{
    params.stribeck = EPF_STRIBECK_LORENTZIAN;
    every_path(measure);
}

static void form_gaussian(void)
{
    params.stribeck = EPF_STRIBECK_GAUSSIAN;
    every_path(measure);
}

static void form_coulomb(void)
{
    params.stribeck = EPF_STRIBECK_COULOMB;
    every_path(measure);
}

int run_naive(void)
{
    form_lorentzian();
    form_gaussian();
    form_coulomb();
    return disagreements;
}
