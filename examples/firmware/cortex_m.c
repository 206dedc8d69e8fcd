/* SPDX-License-Identifier: MIT */
/* Any Cortex-M: its vector table, and the few registers of the interrupt controller in use. */
#include "board.h"
#include "stack.h"

#include <stdio.h>
#include <stdlib.h>

/* Architecture, not vendor: the same addresses on every Cortex-M */
#define REGISTER(address) (*(volatile uint32_t *)(address))
#define SYST_CSR          REGISTER(0xe000e010u)
#define SYST_RVR          REGISTER(0xe000e014u)
#define SYST_CVR          REGISTER(0xe000e018u)
#define NVIC_ISER         REGISTER(0xe000e100u)
#define NVIC_ISPR         REGISTER(0xe000e200u)
#define NVIC_IPR0         REGISTER(0xe000e400u) /* a byte for each of the interrupts 0 to 3 */

enum { ENCODER = 0, CONTROL = 1 }; /* interrupt numbers: on a board those of its peripherals */

#define LOWEST_PRIORITY 0xc0u /* the two bits that also a Cortex-M0 has; 0 is the highest */
#define SYST_RUN        7u    /* counts clocks of the core, and interrupts */

static void pend(int interrupt)
{
    NVIC_ISPR = 1u << interrupt;
    __asm__ volatile("dsb\n isb" ::: "memory"); /* not one instruction later */
}

void board_start(void)
{
    uint8_t *pointer;
    __asm__("mov %0, sp" : "=r"(pointer));
    stack_paint(pointer);
    NVIC_IPR0 = LOWEST_PRIORITY << 8 * CONTROL; /* and 0 for the encoder, as for SysTick */
    NVIC_ISER = 1u << ENCODER | 1u << CONTROL;
}

void board_pend_encoder(void)
{
    pend(ENCODER);
}

void board_pend_control(void)
{
    pend(CONTROL);
}

void board_pend_encoder_after(uint16_t clocks)
{
    SYST_RVR = clocks;
    SYST_CVR = 0;
    SYST_CSR = SYST_RUN;
}

static void systick(void)
{
    SYST_CSR = 0;
    encoder_interrupt();
}

void board_put(char c)
{
    (void)putchar(c); /* to the console of the emulator */
}

bool board_report(void)
{
    return stack_report();
}

/* ---- start-up: after reset the core loads the first two words, picolibc does the rest ------- */

extern uint32_t __stack[];
void _start(void);

static void fault(void)
{
    (void)puts("fault");
    _Exit(EXIT_FAILURE);
}

typedef struct {
    uint32_t *stack;
    void (*exceptions[15])(void);
    void (*interrupts[2])(void);
} vector_table_t;

extern const vector_table_t __interrupt_vector;

__attribute__((section(".data.init.enter"))) const vector_table_t __interrupt_vector = {
    .stack = __stack,
    .exceptions = {_start, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault,
                   fault, fault, fault, systick},
    .interrupts = {[ENCODER] = encoder_interrupt, [CONTROL] = control_interrupt},
};
