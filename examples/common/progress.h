/* SPDX-License-Identifier: MIT */
/* How far long work has come: one line on stderr, written over again and again and removed at the end. It
   is shown on a terminal only. */
#ifndef PROGRESS_H
#define PROGRESS_H

/* Shows a text, as for printf, in place of the one before. It may be called as often as you like: the line
   changes at most ten times per second. */
void progress_show(const char *format, ...);

/* Removes the line, if there is one. To be called before anything else is printed; problem() does it. */
void progress_end(void);

#endif
