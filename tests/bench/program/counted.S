/* SPDX-License-Identifier: MIT */
/*
 * Counted by hand; the tool compares what it measures with these figures in every image
 * (COUNTED in timing.py). M3 and M4F: typical, lowest, highest.
 */
    .text
    .global counted_loop
    .type counted_loop, %function

#if defined(__arm__)
    .syntax unified
    .thumb_func
counted_loop:                    /*  M0  M0+  M3, M4F  lo  hi */
    push {r4, lr}           /*   3   3   3         3   3 */
    movs r4, #10            /*   1   1   1         1   1 */
1:  subs r4, #1             /*  10  10  10        10  10  ten times */
    bne 1b                  /*  28  19  28        19  37  nine times taken */
    sub sp, #8              /*   1   1   1         1   1 */
    str r4, [sp]            /*   2   2   2         1   2 */
    ldr r4, [sp]            /*   2   2   1         1   2  behind a store */
    muls r4, r4             /*   1   1   1         1   1 */
    add sp, #8              /*   1   1   1         1   1 */
#if __ARM_ARCH >= 7
    udiv r4, r4, r4         /*           7         2  12  M3 and up */
#endif
#ifdef __ARM_FP
    vmov.f32 s0, #1.0       /*           1         1   1  M4F and up */
    vmul.f32 s0, s0, s0     /*           1         1   1 */
    vadd.f32 s0, s0, s0     /*           2         2   2  waits for the product */
    vdiv.f32 s0, s0, s0     /*          15        15  15  waits for the sum */
#endif
    pop {r4, pc}            /*   6   5   5         4   6 */

#elif defined(__riscv)
counted_loop:
    addi sp, sp, -16
    sw s0, 12(sp)
    li s0, 10
1:  addi s0, s0, -1         /* ten times */
    bnez s0, 1b             /* ten times */
    lw s0, 12(sp)
    addi sp, sp, 16
    ret                     /* 26 instructions */

#elif defined(__AVR__)
counted_loop:
    push r16                /*  2 */
    ldi r16, 10             /*  1 */
1:  dec r16                 /* 10  ten times */
    brne 1b                 /* 19  nine times taken */
    mul r16, r16            /*  2 */
    pop r16                 /*  2 */
    ret                     /*  4, and 5 where the program counter has three bytes */
#endif

    .size counted_loop, . - counted_loop
