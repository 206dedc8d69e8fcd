/* SPDX-License-Identifier: MIT */
/* A trap ends the run: the start-up of picolibc leaves mtvec at 0, where there is nothing. */
#include <stdio.h>
#include <stdlib.h>

__attribute__((aligned(4))) static void trap(void)
{
    (void)puts("trap");
    _Exit(EXIT_FAILURE);
}

__attribute__((constructor)) static void catch_traps(void)
{
    __asm__ volatile(".option push\n"
                     ".option arch, +zicsr\n" /* in -march it would select the wrong library */
                     "csrw mtvec, %0\n"
                     ".option pop" ::"r"(trap));
}
