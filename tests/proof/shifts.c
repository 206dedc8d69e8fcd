/* SPDX-License-Identifier: MIT */
/*
 * The lemmas of shifts.h. They follow from what a shift is, a product or a quotient by a power of
 * two, and are proven amount by amount: the scripts in wp/script tell Frama-C to enumerate n.
 */

/*@ axiomatic Powers {
      logic integer pow2(integer n) = n <= 0 ? 1 : 2 * pow2(n - 1);
    }

    lemma pow2_values:
      pow2(0) == 1 && pow2(1) == 2 && pow2(2) == 4 && pow2(3) == 8 && pow2(4) == 16 &&
      pow2(5) == 32 && pow2(6) == 64 && pow2(7) == 128 && pow2(8) == 256 && pow2(9) == 512 &&
      pow2(10) == 1024 && pow2(11) == 2048 && pow2(12) == 4096 && pow2(13) == 8192 &&
      pow2(14) == 16384 && pow2(15) == 32768 && pow2(16) == 65536 && pow2(17) == 131072 &&
      pow2(18) == 262144 && pow2(19) == 524288 && pow2(20) == 1048576 && pow2(21) == 2097152 &&
      pow2(22) == 4194304 && pow2(23) == 8388608 && pow2(24) == 16777216 &&
      pow2(25) == 33554432 && pow2(26) == 67108864 && pow2(27) == 134217728 &&
      pow2(28) == 268435456 && pow2(29) == 536870912 && pow2(30) == 1073741824 &&
      pow2(31) == 2147483648 && pow2(32) == 4294967296 && pow2(57) == 144115188075855872;

    // A shift multiplies or divides by a power of two
    lemma shift_left: \forall integer x, n; 0 <= n <= 32 ==> (x << n) == x * pow2(n);
    lemma shift_right: \forall integer x, n; 0 <= x && 0 <= n <= 57 ==> (x >> n) == x / pow2(n);
*/

#include "shifts.h"
