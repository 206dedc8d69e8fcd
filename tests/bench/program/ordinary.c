/* SPDX-License-Identifier: MIT */
/* The tool takes the contact from the name of the function contact_... that it finds in the trace. */
#include "contact.h"

/* Table II of the paper, with a viscous term, so that nothing is left out because it is zero; in
   counts of 10 nm, 1 um/s, 0.1 mN, 10 us: a leap fits 16 bits, and so does 30 v_s */
static void contact_ordinary(run_t *run, kind_t kind)
{
    static const contact_t contact = {
        {1e5f, 1e3f, 0.4f, 1.0f, 1.5f, 1e-3f, 8e-6f, ANY_KIND}, {1e-8f, 1e-6f, 1e-4f, 1e-5f}, 3};
    run_as(kind, run, &contact);
}

/* One that starts hard: displacements of several z_ss are no leap, which is 2 z_max */
static void contact_sticky(run_t *run, kind_t kind)
{
    static const contact_t contact = {
        {1e5f, 1e3f, 0.4f, 1.0f, 5.0f, 1e-3f, 8e-6f, ANY_KIND}, {1e-8f, 1e-6f, 1e-3f, 1e-5f}, 1};
    run_as(kind, run, &contact);
}

void ordinary_contacts(run_t *run, kind_t kind)
{
    contact_ordinary(run, kind);
    contact_sticky(run, kind);
}
