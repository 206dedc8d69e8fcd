/* SPDX-License-Identifier: MIT */
/* A fault ends the run: the handler of picolibc would wait in a loop. */
#include <stdio.h>
#include <stdlib.h>

void arm_hardfault_isr(void);

void arm_hardfault_isr(void)
{
    (void)puts("hard fault");
    _Exit(EXIT_FAILURE);
}
