/* SPDX-License-Identifier: MIT */
/* The cells of a row of a CSV file, which may be quoted. */
#ifndef CSV_CELL_H
#define CSV_CELL_H

/* Cuts the next cell off *rest, which becomes NULL after the last one. NULL for a bad quotation. */
const char *csv_next_cell(char **rest);

#endif
