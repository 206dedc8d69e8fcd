/* SPDX-License-Identifier: MIT */
#ifndef RUN_H
#define RUN_H

/* Runs what is measured in this program; returns how often something was not as it should be */
int run(void);

#endif
