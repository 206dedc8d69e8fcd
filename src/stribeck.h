/* SPDX-License-Identifier: MIT */
/* EPF_STRIBECK_ONLY, where all variants ask for it. */
#ifndef EPF_STRIBECK_H
#define EPF_STRIBECK_H

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

#endif
