/* SPDX-License-Identifier: MIT */
/* Gains and lengths of few digits and of many: what shifts, and what is normalised, depends on them.
   The tool takes their names from the trace. */
#include "contact.h"

/* z_max is below two counts: z_shift is 29. Velocity, force and time are as coarse. */
static void contact_coarse(run_t *run, kind_t kind)
{
    static const contact_t contact = {
        {1e5f, 1e3f, 0.4f, 1.0f, 1.5f, 1e-3f, 8e-6f, ANY_KIND}, {8e-6f, 1e-3f, 1.0f, 1e-1f}, 1};
    run_as(kind, run, &contact);
}

/* z_max is just below 2^30 counts: z_shift is 0 */
static void contact_fine(run_t *run, kind_t kind)
{
    static const contact_t contact = {
        {1e5f, 1e3f, 0.4f, 1.0f, 1.5f, 1e-3f, 8e-6f, ANY_KIND}, {1.5e-14f, 1e-7f, 5e-5f, 1e-7f}, 1};
    run_as(kind, run, &contact);
}

/* The gains of the viscous and the damping term are as large as may be: both saturate */
static void contact_saturating(run_t *run, kind_t kind)
{
    static const contact_t contact = {
        {1e5f, 1e7f, 1e10f, 1.0f, 1.5f, 1e-3f, 8e-6f, ANY_KIND}, {1e-8f, 1e-6f, 1e-4f, 1e-5f}, 1};
    run_as(kind, run, &contact);
}

/* They vanish: sigma_1 is 0, the viscous term stays below one unit */
static void contact_undamped(run_t *run, kind_t kind)
{
    static const contact_t contact = {
        {1e5f, 0.0f, 1e-12f, 1.0f, 1.5f, 1e-3f, 8e-6f, ANY_KIND}, {1e-8f, 1e-6f, 1e-4f, 1e-5f}, 1};
    run_as(kind, run, &contact);
}

/* f_max next to f_c, z_ba next to z_c: spans of few units */
static void contact_narrow(run_t *run, kind_t kind)
{
    static const contact_t contact = {
        {1e5f, 1e-9f, 0.4f, 1.0f, 1.000001f, 1e-3f, 9.99999e-6f, ANY_KIND},
        {1e-8f, 1e-6f, 1e-4f, 1e-5f},
        1};
    run_as(kind, run, &contact);
}

void integer_contacts(run_t *run, kind_t kind)
{
    ordinary_contacts(run, kind);
    if (kind.form == EPF_STRIBECK_COULOMB) {
        return; /* the others take every way that it takes */
    }
    contact_coarse(run, kind);
    contact_fine(run, kind);
    contact_saturating(run, kind);
    contact_undamped(run, kind);
    contact_narrow(run, kind);
}

/* The force in counts of 1 nN, too many for 16 bits: it is scaled by less than a word */
static void contact_resolved(run_t *run, kind_t kind)
{
    static const contact_t contact = {
        {1e5f, 1e3f, 0.4f, 1.0f, 1.5f, 1e-3f, 8e-6f, ANY_KIND}, {8e-6f, 1e-3f, 1e-9f, 1e-1f}, 1};
    run_as(kind, run, &contact);
}

void wide_contacts(run_t *run, kind_t kind)
{
    integer_contacts(run, kind);
    contact_resolved(run, kind);
}
