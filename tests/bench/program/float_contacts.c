/* SPDX-License-Identifier: MIT */
/* Where single precision comes to its ends: every product that can leave the range of float does, in
   one contact or the other. The tool takes their names from the trace. */
#include "contact.h"

#define NO_COUNTS 1.0f, 1.0f, 1.0f, 1.0f

/* z_ss (z_ss - z_ba) underflows to 0; the viscous and the damping term overflow */
static void contact_stiff(run_t *run, kind_t kind)
{
    static const contact_t contact = {
        {1e28f, 3e38f, 3e38f, 1.0f, 1.5f, 10.0f, 8e-29f, ANY_KIND}, {NO_COUNTS}, 1};
    run_as(kind, run, &contact);
}

/* The same product overflows; there are no other terms than sigma_0 z */
static void contact_soft(run_t *run, kind_t kind)
{
    static const contact_t contact = {
        {1e-30f, 0.0f, 0.0f, 1.0f, 1.5f, 1e-30f, 8e29f, ANY_KIND}, {NO_COUNTS}, 1};
    run_as(kind, run, &contact);
}

/* f_max next to f_c, z_ba next to z_c, and as small as may be: gaps and spans are subnormal */
static void contact_narrow(run_t *run, kind_t kind)
{
    static const contact_t contact = {
        {1.0f, 1e30f, 1e30f, 0x1.000002p-103f, 0x1.000004p-103f, 1e-3f, 0x1p-103f, ANY_KIND},
        {NO_COUNTS},
        1};
    run_as(kind, run, &contact);
}

/* The damping term overflows, where sigma_1 dz need not */
static void contact_damped(run_t *run, kind_t kind)
{
    static const contact_t contact = {
        {1e5f, 3e38f, 0.0f, 1.0f, 1.5f, 1e-3f, 8e-6f, ANY_KIND}, {NO_COUNTS}, 1};
    run_as(kind, run, &contact);
}

void float_contacts(run_t *run, kind_t kind)
{
    ordinary_contacts(run, kind);
    if (kind.form == EPF_STRIBECK_COULOMB) {
        return; /* the others take every way that it takes */
    }
    contact_stiff(run, kind);
    contact_soft(run, kind);
    contact_narrow(run, kind);
    contact_damped(run, kind);
}
