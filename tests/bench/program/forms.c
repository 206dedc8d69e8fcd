/* SPDX-License-Identifier: MIT */
/* The tool takes the form of f_ss from the names of these functions, which it finds in the trace. */
#include "contact.h"

void run_in_form(run_t *run, const contact_t *contact, epf_stribeck_t form)
{
    contact_t formed = *contact;
    formed.params.stribeck = form;
    run(&formed);
}

static void form_lorentzian(contacts_t *contacts, run_t *run)
{
    contacts(run, EPF_STRIBECK_LORENTZIAN);
}

static void form_gaussian(contacts_t *contacts, run_t *run)
{
    contacts(run, EPF_STRIBECK_GAUSSIAN);
}

static void form_coulomb(contacts_t *contacts, run_t *run)
{
    contacts(run, EPF_STRIBECK_COULOMB);
}

void every_form(contacts_t *contacts, run_t *run)
{
    form_lorentzian(contacts, run);
    form_gaussian(contacts, run);
    form_coulomb(contacts, run);
}
