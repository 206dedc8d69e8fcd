/* SPDX-License-Identifier: MIT */
/* The other one: both together are too long for the flash of an ATmega328P. */
#include "counted.h"
#include "run.h"

int main(void)
{
    count();
    return run_f32() + run_naive() == 0 ? 0 : 1;
}
