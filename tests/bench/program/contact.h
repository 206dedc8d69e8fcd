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

/* Measures one contact */
typedef void run_t(const contact_t *contact);

/* Runs contacts, which have that form of f_ss */
typedef void contacts_t(run_t *run, epf_stribeck_t form);

/* Table II of the paper; and with it the corners of the parameters: of f32, of q15, of q31 */
contacts_t ordinary_contact, float_contacts, integer_contacts, wide_contacts;

#define ANY_FORM EPF_STRIBECK_LORENTZIAN /* run_in_form() says which */

void run_in_form(run_t *run, const contact_t *contact, epf_stribeck_t form);

/* Runs them in each form */
void every_form(contacts_t *contacts, run_t *run);

#endif
