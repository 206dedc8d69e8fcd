/* SPDX-License-Identifier: MIT */
#ifndef COUNTED_H
#define COUNTED_H

/* Instructions that are counted by hand, see counted.S */
void counted_loop(void);
int counted_path(int longer);

static inline void count(void)
{
    counted_loop();
    (void)counted_path(0);
    (void)counted_path(1);
}

#endif
