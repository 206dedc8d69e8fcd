/* SPDX-License-Identifier: MIT */
/* The tool takes update rule and form of f_ss from the names of these functions, which it finds in the
   trace. */
#include "contact.h"

void run_as(kind_t kind, run_t *run, const contact_t *contact)
{
    contact_t of_kind = *contact;
    of_kind.params.stribeck = kind.form;
    of_kind.params.update = kind.rule;
    run(&of_kind);
}

static void form_lorentzian(epf_update_t rule, contacts_t *contacts, run_t *run)
{
    contacts(run, (kind_t){EPF_STRIBECK_LORENTZIAN, rule});
}

static void form_gaussian(epf_update_t rule, contacts_t *contacts, run_t *run)
{
    contacts(run, (kind_t){EPF_STRIBECK_GAUSSIAN, rule});
}

static void form_coulomb(epf_update_t rule, contacts_t *contacts, run_t *run)
{
    contacts(run, (kind_t){EPF_STRIBECK_COULOMB, rule});
}

void every_form(epf_update_t rule, contacts_t *contacts, run_t *run)
{
    form_lorentzian(rule, contacts, run);
    form_gaussian(rule, contacts, run);
    form_coulomb(rule, contacts, run);
}

static void rule_saturated(contacts_t *contacts, run_t *run)
{
    every_form(EPF_UPDATE_SATURATED, contacts, run);
}

static void rule_mean_value(contacts_t *contacts, run_t *run)
{
    every_form(EPF_UPDATE_MEAN_VALUE, contacts, run);
}

void every_rule(contacts_t *contacts, run_t *run)
{
    rule_saturated(contacts, run);
    rule_mean_value(contacts, run);
}
