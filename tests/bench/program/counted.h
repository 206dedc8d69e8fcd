/* SPDX-License-Identifier: MIT */
#ifndef COUNTED_H
#define COUNTED_H

/* Instructions that are counted by hand, see counted.S */
void counted_loop(void);

#endif
