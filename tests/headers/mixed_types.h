/* SPDX-License-Identifier: MIT */
/*
 * Calls of one variant, in C or C++, with a contact and coefficients of a type. Compiled by
 * mixed_types.cmake, which defines CALL, one of these, and TYPE, q31 or q15.
 */
#include "epf/epf.h"

#define JOINED(a, b, c)  JOINED_(a, b, c)
#define JOINED_(a, b, c) a##b##c

typedef JOINED(epf_, TYPE, _t) contact_t;
typedef JOINED(epf_, TYPE, _coeffs_t) coeffs_t;

void call(contact_t *ep, coeffs_t *coeffs, const epf_params_t *params, const epf_lsb_t *lsb);

void call(contact_t *ep, coeffs_t *coeffs, const epf_params_t *params, const epf_lsb_t *lsb)
{
    (void)ep;
    (void)coeffs;
    (void)params;
    (void)lsb;
    CALL;
}
