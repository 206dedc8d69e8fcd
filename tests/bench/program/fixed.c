/* SPDX-License-Identifier: MIT */
/* One of the two programs that are traced. They measure nothing: the tool counts what it sees executed. */
#include "counted.h"
#include "run.h"

int main(void)
{
    count();
    return run_q31() + run_q15() == 0 ? 0 : 1;
}
