/* SPDX-License-Identifier: MIT */
/* EPF_STRIBECK_ONLY and EPF_UPDATE_ONLY, where all variants ask for them. */
#ifndef EPF_ONLY_H
#define EPF_ONLY_H

#include "epf/params.h"

#ifdef EPF_STRIBECK_ONLY
typedef char epf_stribeck_only_must_be_a_form[EPF_STRIBECK_ONLY <= EPF_STRIBECK_COULOMB ? 1 : -1];
#endif
#ifdef EPF_UPDATE_ONLY
typedef char epf_update_only_must_be_a_rule[EPF_UPDATE_ONLY <= EPF_UPDATE_MEAN_VALUE ? 1 : -1];
#endif

/* The form of f_ss(v); known to the compiler where the library is built for one form only */
/*@ assigns \nothing; */
static inline epf_stribeck_t form_in_use(epf_stribeck_t form)
{
#ifdef EPF_STRIBECK_ONLY
    (void)form;
    return EPF_STRIBECK_ONLY;
#else
    return form;
#endif
}

/* The same of the update rule */
/*@ assigns \nothing; */
static inline epf_update_t rule_in_use(epf_update_t rule)
{
#ifdef EPF_UPDATE_ONLY
    (void)rule;
    return EPF_UPDATE_ONLY;
#else
    return rule;
#endif
}

#endif
