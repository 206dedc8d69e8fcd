/* SPDX-License-Identifier: MIT */
/* The contacts that are measured. */
#ifndef CONTACT_H
#define CONTACT_H

#include <epf/params.h>

typedef struct {
    epf_params_t params;
    epf_lsb_t lsb; /* what one count weighs in q31 and q15; not used by f32 */
    int operands;  /* how many sets of them, 1 to 3: see paths.c */
} contact_t;

/* What a contact is measured with */
typedef struct {
    epf_stribeck_t form;
    epf_update_t rule;
} kind_t;

#define ANY_KIND EPF_STRIBECK_LORENTZIAN, EPF_UPDATE_SATURATED /* run_as() says which */

/* Measures one contact */
typedef void run_t(const contact_t *contact);

void run_as(kind_t kind, run_t *run, const contact_t *contact);

/* Runs contacts */
typedef void contacts_t(run_t *run, kind_t kind);

/* Two without corners; and with it the corners of the parameters: of f32, of q15, of q31 */
contacts_t ordinary_contacts, float_contacts, integer_contacts, wide_contacts;

/* Runs them in each form of f_ss; and that by each update rule */
void every_form(epf_update_t rule, contacts_t *contacts, run_t *run);
void every_rule(contacts_t *contacts, run_t *run);

#endif
