/* SPDX-License-Identifier: MIT */
/* ATmega328P: two pins that are outputs pend their own interrupts, and the first UART prints. */
#include "board.h"
#include "stack.h"

#include <avr/interrupt.h>
#include <avr/io.h>

/* The core has one priority. The control interrupt lowers its own: it lets itself be interrupted, by
   anything but itself. */
ISR(PCINT0_vect)
{
    PCICR = 0;
    sei();
    control_interrupt();
    cli();
    PCICR = 1 << PCIE0;
}

ISR(INT0_vect)
{
    encoder_interrupt();
}

ISR(TIMER1_COMPA_vect)
{
    TCCR1B = 0;
    encoder_interrupt();
}

/* The interrupt logic sees a pin some clocks after it was written */
static void wait_for_edge(void)
{
    __asm__ volatile("nop\n nop\n nop\n nop\n nop\n nop" ::: "memory");
}

void board_start(void)
{
    stack_paint((uint8_t *)SP);
    UCSR0A = 1 << U2X0; /* with a divisor of 0, as fast as it goes */
    UCSR0B = 1 << TXEN0;
    EICRA = 1 << ISC01 | 1 << ISC00; /* INT0, at a rising edge */
    DDRD = 1 << PD2;
    EIMSK = 1 << INT0;
    DDRB = 1 << PB0; /* PCINT0, at any edge */
    PCMSK0 = 1 << PCINT0;
    PCICR = 1 << PCIE0;
    TIMSK1 = 1 << OCIE1A;
    sei();
}

void board_pend_encoder(void)
{
    PORTD &= (uint8_t) ~(1 << PD2);
    PORTD |= 1 << PD2;
    wait_for_edge();
}

void board_pend_control(void)
{
    PINB = 1 << PB0; /* toggles it */
    wait_for_edge();
}

void board_pend_encoder_after(uint16_t clocks)
{
    TCNT1 = 0;
    OCR1A = clocks;
    TIFR1 = 1 << OCF1A;
    TCCR1B = 1 << CS10; /* runs, by the clock of the core */
}

void board_put(char c)
{
    while ((UCSR0A & 1 << UDRE0) == 0) {
    }
    UDR0 = (uint8_t)c;
}

bool board_report(void)
{
    return stack_report();
}
