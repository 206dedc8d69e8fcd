/* SPDX-License-Identifier: MIT */
/*
 * Calls every public function of a variant on every path, for every contact in every form, by every
 * update rule. Included
 * once by the file of a variant, which has defined
 *   EPF(name)       the function or type of that variant
 *   MAKE(made, of)  the call that makes coefficients of a contact
 *   Z, X, V, T(si)  its deflection, displacement, velocity and time
 *   DEFLECTION, SIGNAL, TIME  their types
 *   CONTACTS        the contacts that it is measured on
 */
#include "paths.h"
#include "run.h"

static EPF(coeffs_t) coeffs;
static const epf_lsb_t *lsb;
static SIGNAL earlier_v; /* what is kept where the velocity is rejected: z_ss is z_c */
static unsigned motions; /* of this contact, so far */
static int refused;

/* A contact has two operating points, which take turns: where a path is run with another operand, it
   finds the other one published. That is so by the number of motions in between, 46. */
static void take_turns(EPF(t) * contact)
{
    EPF(set_velocity)(contact, earlier_v);
    if ((motions / 2 + motions) % 2 != 0) {
        EPF(set_velocity)(contact, earlier_v);
    }
    motions++;
}

/* The calls one by one, as firmware with an encoder interrupt has them; then the joined ones, each
   from the same deflection */
static void measure(motion_t by)
{
    const DEFLECTION z = Z(by.z);
    const SIGNAL dx = X(by.dx), v = V(by.v);
    const TIME dt = T(by.dt);
    EPF(t) contact;

    EPF(init)(&contact, &coeffs);
    EPF(reset)(&contact, z);
    take_turns(&contact);
    const EPF(t) deflected = contact;

    EPF(set_velocity)(&contact, v);
    (void)EPF(advance)(&contact, dx);
    (void)EPF(force)(&contact, dt);
    (void)EPF(output)(&contact);
    (void)EPF(z)(&contact);

    contact = deflected;
    (void)EPF(update)(&contact, dx, v);
    contact = deflected;
    (void)EPF(step)(&contact, dx, v, dt);

    (void)EPF(fss)(&coeffs, v);
    (void)EPF(alpha)(&coeffs, z, v);
}

static epf_status_t path_start_up(const contact_t *contact)
{
    return MAKE(&coeffs, contact);
}

static void measure_contact(const contact_t *contact)
{
    lsb = &contact->lsb;
    const epf_status_t status = path_start_up(contact);
    if (status == EPF_OK) {
        /* So that both rules find the same, and another form the other one */
        motions = 2u * (unsigned)contact->params.stribeck;
        earlier_v = V(20.0f * contact->params.v_s);
        every_path(contact, measure);
    } else if (status != EPF_ERR_UPDATE) { /* the other rule, in a build with one */
        refused++;
    }
}

int run(void)
{
    (void)lsb; /* f32 has no use for it */
    every_rule(CONTACTS, measure_contact);
    return refused;
}
