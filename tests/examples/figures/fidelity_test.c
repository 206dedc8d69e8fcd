/* SPDX-License-Identifier: MIT */
/* What a step costs, as read from the baseline of the benchmark */
#include "fidelity_costs.h"
#include "unity.h"

#include <stdio.h>

static const char file[] = "fidelity_test.csv";

void setUp(void)
{
}

void tearDown(void)
{
    (void)remove(file);
}

static void write_baseline(const char *text)
{
    FILE *stream = fopen(file, "w");
    TEST_ASSERT_NOT_NULL(stream);
    (void)fputs(text, stream);
    (void)fclose(stream);
}

/* 0 if it is not measured */
static unsigned long step_cycles(const char *variant, const char *rule)
{
    step_cost_t costs[] = {{NULL, NULL, 0}, {variant, rule, 0}};
    TEST_ASSERT_TRUE(step_costs_read(costs, 2, file));
    TEST_ASSERT_EQUAL_UINT(0, costs[0].cycles);
    return costs[1].cycles;
}

static void test_a_step_costs_the_most_of_its_paths(void)
{
    write_baseline("variant,function,rule,path,metric,cortex-m0,cortex-m4f,cortex-m7\n"
                   "f32,step,saturated,elastic,cost,9001,301,9003\n"
                   "f32,step,saturated,mixed,cost,9001,344,9003\n"
                   "f32,step,saturated,leap,cost,9001,315,9003\n");
    TEST_ASSERT_EQUAL_UINT(344, step_cycles("f32", "saturated"));
}

static void test_what_is_of_something_else_costs_nothing(void)
{
    write_baseline("variant,function,rule,path,metric,cortex-m4f\n"
                   "f32,step,mean_value,mixed,cost,7\n"
                   "q31,step,mean_value,mixed,cost,9001\n"
                   "f32,advance,mean_value,mixed,cost,9002\n"
                   "f32,step,saturated,mixed,cost,9003\n"
                   "f32,step,mean_value alone,mixed,cost,9004\n"
                   "f32,step,mean_value,worst,bound,9005\n");
    TEST_ASSERT_EQUAL_UINT(7, step_cycles("f32", "mean_value"));
}

static void test_columns_are_found_by_name(void)
{
    write_baseline("cortex-m4f,metric,core,rule,function,variant\n12,cost,9,any,step,naive\n");
    TEST_ASSERT_EQUAL_UINT(12, step_cycles("naive", "any"));
}

static void test_there_is_no_cost_where_it_was_not_measured(void)
{
    write_baseline("variant,function,rule,path,metric,cortex-m0,cortex-m4f\n"
                   "f32,step,saturated,mixed,cost,9001,\n");
    TEST_ASSERT_EQUAL_UINT(0, step_cycles("f32", "saturated"));
    TEST_ASSERT_EQUAL_UINT(0, step_cycles("q31", "saturated"));
}

/* What is reported, the command line of figures.cmake checks */
static void test_what_is_no_baseline_is_refused(void)
{
    step_cost_t cost = {"f32", "saturated", 0};
    TEST_ASSERT_FALSE(step_costs_read(&cost, 1, "none.csv"));
    write_baseline("variant,function,path,metric,cortex-m4f\nf32,step,mixed,cost,9001\n");
    TEST_ASSERT_FALSE(step_costs_read(&cost, 1, file));
    write_baseline("");
    TEST_ASSERT_FALSE(step_costs_read(&cost, 1, file));
    TEST_ASSERT_EQUAL_UINT(0, cost.cycles);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_a_step_costs_the_most_of_its_paths);
    RUN_TEST(test_what_is_of_something_else_costs_nothing);
    RUN_TEST(test_columns_are_found_by_name);
    RUN_TEST(test_there_is_no_cost_where_it_was_not_measured);
    RUN_TEST(test_what_is_no_baseline_is_refused);
    return UNITY_END() != 0;
}
