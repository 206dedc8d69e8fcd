/* SPDX-License-Identifier: MIT */
/*
 * Counted by hand; the tool compares what it measures, and the bound that it finds, with these figures
 * in every image (COUNTED in timing.py). M3 and M4F: typical, lowest, highest.
 */
    .text
    .macro function name
    .global \name
    .type \name, %function
#ifdef __arm__
    .thumb_func
#endif
\name:
    .endm
    .macro end name
    .size \name, . - \name
    .endm

#if defined(__arm__)
    .syntax unified

    function counted_loop   /*  M0  M0+  M3, M4F  lo  hi */
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
    umull r4, r3, r4, r4    /*         5 1       3 1 5 1  M3, M4F */
#endif
#ifdef __ARM_FP
    vmov.f32 s0, #1.0       /*           1         1   1  M4F and up */
    vmul.f32 s0, s0, s0     /*           1         1   1 */
    vadd.f32 s0, s0, s0     /*           2         2   2  waits for the product */
    vdiv.f32 s0, s0, s0     /*          15        15  15  waits for the sum */
#endif
    pop {r4, pc}            /*   6   5   5         4   6 */
    end counted_loop

    function counted_path   /*  with 1; with 0 it is shorter */
    push {r4, lr}           /*   3   3   3         3   3 */
    cmp r0, #0              /*   1   1   1         1   1 */
    beq 1f                  /*   1   1   1         1   1  not taken */
    bl counted_leaf         /*   4   3   3         2   4 */
#if __ARM_ARCH >= 7
    cmp r0, #0              /*           1         1   1  M3 and up */
    it eq                   /*           1         0   1 */
    popeq {r4, pc}          /*           1         1   1  skipped */
#endif
1:  pop {r4, pc}            /*   6   5   5         4   6 */
    end counted_path

    function counted_leaf
    sub sp, #8              /*   1   1   1         1   1 */
    str r0, [sp]            /*   2   2   2         1   2 */
    ldr r0, [sp]            /*   2   2   1         1   2  behind a store */
#ifdef __ARM_FP
    vstr s0, [sp]           /*           2         2   2  M4F and up: overlaps with nothing */
    vldr s0, [sp]           /*           2         2   2 */
#endif
    add sp, #8              /*   1   1   1         1   1 */
    bx lr                   /*   3   2   3         2   4 */
    end counted_leaf

    function refused_recursion
    push {r4, lr}
    bl refused_recursion
    pop {r4, pc}
    end refused_recursion

    function refused_jump
    bx r0
    end refused_jump

#elif defined(__riscv)
    function counted_loop
    addi sp, sp, -16
    sw s0, 12(sp)
    li s0, 10
1:  addi s0, s0, -1         /* ten times */
    bnez s0, 1b             /* ten times */
    lw s0, 12(sp)
    addi sp, sp, 16
    ret                     /* 26 instructions */
    end counted_loop

    function counted_path
    addi sp, sp, -16
    sw ra, 12(sp)
    beqz a0, 1f
    jal counted_leaf
1:  lw ra, 12(sp)
    addi sp, sp, 16
    ret                     /* 7 instructions, with 1 */
    end counted_path

    function counted_leaf
    addi sp, sp, -16
    sw a0, 12(sp)
    lw a0, 12(sp)
    addi sp, sp, 16
    ret                     /* 5 instructions */
    end counted_leaf

    function refused_recursion
    addi sp, sp, -16
    sw ra, 12(sp)
    jal refused_recursion
    lw ra, 12(sp)
    addi sp, sp, 16
    ret
    end refused_recursion

    function refused_jump
    jr a0
    end refused_jump

#elif defined(__AVR__)      /* in brackets: where the program counter has three bytes */
    function counted_loop
    push r16                /*  2 */
    ldi r16, 10             /*  1 */
1:  dec r16                 /* 10  ten times */
    brne 1b                 /* 19  nine times taken */
    mul r16, r16            /*  2 */
    pop r16                 /*  2 */
    ret                     /*  4 (5) */
    end counted_loop

    function counted_path
    tst r24                 /*  1 */
    breq 1f                 /*  1  not taken */
    rcall counted_leaf      /*  3 (4) */
1:  ret                     /*  4 (5) */
    end counted_path

    function counted_leaf
    push r16                /*  2 */
    pop r16                 /*  2 */
    ret                     /*  4 (5) */
    end counted_leaf
#endif
