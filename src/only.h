/* SPDX-License-Identifier: MIT */
/* EPF_STRIBECK_ONLY and EPF_UPDATE_ONLY, where all variants ask for them. */
#ifndef EPF_ONLY_H
#define EPF_ONLY_H

#include "epf/params.h"

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
