/* SPDX-License-Identifier: MIT */
/* The same calls in the same order, for the trace that the cores must repeat bit for bit. */
#include "board.h"

#include <stdio.h>

void board_start(void)
{
}

void board_pend_encoder(void)
{
    encoder_interrupt();
}

void board_pend_control(void)
{
    control_interrupt();
}

void board_put(char c)
{
    (void)putchar(c);
}

bool board_report(void)
{
    return true;
}
