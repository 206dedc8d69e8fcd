/* SPDX-License-Identifier: MIT */
/* The programs that are traced, one of each variant: together they are too long for the flash of an
   ATmega328P. They measure nothing: the tool counts what it sees executed. */
#include "counted.h"
#include "run.h"

int main(void)
{
    count();
    return run() == 0 ? 0 : 1;
}
