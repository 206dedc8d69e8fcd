/* SPDX-License-Identifier: MIT */
/* The example record by the exact solution of the model between its rows. What remains is what the encoder does:
   no rule could do better. */
#include "csv_record.h"
#include "problem.h"
#include "rules.h"
#include "unity.h"

#include <math.h>
#include <stddef.h>

void setUp(void)
{
}

void tearDown(void)
{
}

enum { TIME, POSITION, FORCE, COLUMNS };
static const csv_column_t columns[COLUMNS] = {
    {"time_s", NULL, true},
    {"position_m", NULL, true},
    {"friction_force_N", NULL, true},
};

/* Table II of the paper, in examples/replay/example.params */
static const friction_t friction = {1e5, 1e3, 0.4, 1.0, 1.5, 1e-3, 8e-6, FRICTION_LORENTZIAN};

/* The force at the end of a step, as the library computes it */
static double step(double *z, double dx, double dt)
{
    const double before = *z;
    const double v = dx / dt;
    *z = dx == 0.0 ? before : rule_exact_flow(&friction, before, dx, v, dt);
    return friction.sigma_0 * *z + friction.sigma_1 * (*z - before) / dt + friction.sigma_2 * v;
}

static void test_the_exact_solution_comes_no_closer_to_the_example_than_the_readme_tells(void)
{
    csv_record_t record;
    csv_row_t last;
    csv_row_t row;
    problem_from("exact_test");
    TEST_ASSERT_TRUE(csv_open(&record, EXAMPLE, columns, COLUMNS));
    TEST_ASSERT_TRUE(csv_next(&record, &last) == CSV_ROW);
    double z = 0.0;
    double squares = last.value[FORCE] * last.value[FORCE];
    unsigned long rows = 1;
    for (; csv_next(&record, &row) == CSV_ROW; last = row, rows++) {
        const double force = step(&z, row.value[POSITION] - last.value[POSITION],
                                  row.value[TIME] - last.value[TIME]);
        const double residual = row.value[FORCE] - force;
        squares += residual * residual;
    }
    csv_close(&record);
    const double percent = 100.0 * sqrt(squares / (double)rows); /* of f_c, which is 1 N */
    TEST_ASSERT_DOUBLE_WITHIN(0.01, TOLD_PERCENT, percent);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_the_exact_solution_comes_no_closer_to_the_example_than_the_readme_tells);
    return UNITY_END() != 0;
}
