/* SPDX-License-Identifier: MIT */
#ifndef RUN_H
#define RUN_H

/* Each measures a variant, and returns how many of its contacts were refused */
int run_f32(void);
int run_q31(void);
int run_q15(void);

/* How often Algorithm 1 as transcribed and epf_f32 do not agree on the deflection */
int run_naive(void);

#endif
