/* SPDX-License-Identifier: MIT */
/* The program that is traced. It measures nothing: the tool counts what it sees executed. */
#include "counted.h"
#include "run.h"

int main(void)
{
    counted_loop();
    run_f32();
    run_q31();
    run_q15();
    return run_naive() == 0 ? 0 : 1;
}
