/* SPDX-License-Identifier: MIT */
/*
 * What the provers must know of shifts, proven by shifts.c: the driver puts this page before every
 * file, since to WP a shift by a variable amount is a function that it knows next to nothing of.
 */
#ifndef EPF_PROOF_SHIFTS_H
#define EPF_PROOF_SHIFTS_H

#include "kernel.h"

/*@ lemma shift_left_grows: \forall integer x, n; 0 <= x && 0 <= n <= 32 ==> x <= (x << n);
    lemma shift_right_shrinks: \forall integer x, n;
      0 <= x && 0 <= n <= 32 ==> 0 <= (x >> n) <= x;
    lemma shift_right_of_zero: \forall integer n; 0 <= n <= 63 ==> (0 >> n) == 0;
    lemma shift_right_quarters: \forall integer x, n; 0 <= x && 2 <= n <= 32 ==> (x >> n) <= x / 4;
    lemma shift_right_by: \forall integer x; 0 <= x ==>
      (x >> 4) == x / 16 && (x >> 8) == x / 256 && (x >> 10) == x / 1024 &&
      (x >> 11) == x / 2048 && (x >> 12) == x / 4096 && (x >> 14) == x / 16384 && (x >> 15) == x / 32768 &&
      (x >> 16) == x / 65536 && (x >> 17) == x / 131072 && (x >> 27) == x / 134217728 &&
      (x >> 57) == x / 144115188075855872;

    // So many counts are no leap if and only if they are below 2 z_max
    lemma leap: \forall integer x, y, n;
      0 <= y && 0 <= n <= 29 ==> (x <= (y >> n) <==> (x << n) <= y);

    // How many bits a number has
    lemma length_of_quotient: \forall integer x; 0 <= x < 4294967296 ==>
      (x >= 65536 ==> length(x) == 16 + length(x / 65536)) &&
      (x >= 256 ==> length(x) == 8 + length(x / 256)) &&
      (x >= 16 ==> length(x) == 4 + length(x / 16)) &&
      (x >= 4 ==> length(x) == 2 + length(x / 4));

    // A number of n bits, moved so that its highest one is the 16th, the 32nd
    lemma down_to_16: \forall integer x, n;
      x < 4294967296 && n == length(x) && 16 <= n <= 32 ==> 32768 <= (x >> (n - 16)) < 65536;
    lemma up_to_16: \forall integer x, n;
      n == length(x) && 1 <= n <= 16 ==> 32768 <= (x << (16 - n)) < 65536;
    lemma up_to_32: \forall integer x, n;
      x < 4294967296 && n == length(x) && 1 <= n <= 32 ==>
        2147483648 <= (x << (32 - n)) < 4294967296;
    lemma down_to_32: \forall integer x, n;
      0 <= x < 18446744073709551616 && n == length(x / 4294967296) && 1 <= n <= 32 ==>
        2147483648 <= (x >> n) < 4294967296;
*/

#endif
