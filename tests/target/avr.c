/* SPDX-License-Identifier: MIT */
/* Standard output on the first UART, which avrrun shows. */
#include <avr/io.h>
#include <stdio.h>

static int put(char c, FILE *stream)
{
    (void)stream;
    while ((UCSR0A & (1 << UDRE0)) == 0) {
    }
    UDR0 = (uint8_t)c;
    return 0;
}

static FILE uart = FDEV_SETUP_STREAM(put, NULL, _FDEV_SETUP_WRITE);

__attribute__((constructor)) static void open_uart(void)
{
    UCSR0A = 1 << U2X0; /* with a divisor of 0, as fast as it goes */
    UCSR0B = 1 << TXEN0;
    stdout = &uart;
}
