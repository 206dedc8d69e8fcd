/* SPDX-License-Identifier: MIT */
/* How far long work has come: a line on stderr that is written over and removed at the end. There is none
   unless stderr is a terminal. */
#ifndef PROGRESS_H
#define PROGRESS_H

/* Shows the text, as for printf, in place of the one before; ten times a second, however often it is called */
void progress_show(const char *format, ...);

/* Removes the line, if there is one. To be called before anything else is printed; problem() does it. */
void progress_end(void);

#endif
