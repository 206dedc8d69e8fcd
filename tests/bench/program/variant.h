/* SPDX-License-Identifier: MIT */
/*
 * Calls every public function of a variant on every path, for every Stribeck form. Included once by
 * the file of a variant, which has defined
 *   EPF(name)       the function or type of that variant
 *   COEFFS(form)    the initialiser of its coefficients
 *   MAKE(c, p)      the call that makes coefficients of parameters
 *   Z, X, V, T(si)  its deflection, displacement, velocity and time
 *   RUN             the name of the function that is defined here
 * The tool takes the form from the name of the function form_... that it sees in the trace.
 */
#include "contact.h"
#include "paths.h"
#include "run.h"

static const EPF(coeffs_t) lorentzian = COEFFS(EPF_STRIBECK_LORENTZIAN);
static const EPF(coeffs_t) gaussian = COEFFS(EPF_STRIBECK_GAUSSIAN);
static const EPF(coeffs_t) coulomb = COEFFS(EPF_STRIBECK_COULOMB);
static const EPF(coeffs_t) * coeffs;

/* The calls one by one, as firmware with an encoder interrupt has them; then the joined ones, each
   from the same deflection */
static void measure(float z, float dx, float v, float dt)
{
    EPF(t) contact;
    EPF(init)(&contact, coeffs);
    EPF(reset)(&contact, Z(z));
    const EPF(t) deflected = contact;

    EPF(set_velocity)(&contact, V(v));
    (void)EPF(advance)(&contact, X(dx));
    (void)EPF(force)(&contact, T(dt));
    (void)EPF(output)(&contact);
    (void)EPF(z)(&contact);

    contact = deflected;
    (void)EPF(update)(&contact, X(dx), V(v));
    contact = deflected;
    (void)EPF(step)(&contact, X(dx), V(v), T(dt));

    (void)EPF(fss)(coeffs, V(v));
    (void)EPF(alpha)(coeffs, Z(z), V(v));
}

static void path_start_up(void)
{
    const epf_params_t params = {CONTACT(coeffs->stribeck)};
    EPF(coeffs_t) made;
    (void)MAKE(&made, &params);
}

static void every_call(const EPF(coeffs_t) * of_form)
{
    coeffs = of_form;
    path_start_up();
    every_path(measure);
}

static void form_lorentzian(void)
{
    every_call(&lorentzian);
}

static void form_gaussian(void)
{
    every_call(&gaussian);
}

static void form_coulomb(void)
{
    every_call(&coulomb);
}

void RUN(void)
{
    form_lorentzian();
    form_gaussian();
    form_coulomb();
}
