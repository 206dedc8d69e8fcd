/* SPDX-License-Identifier: MIT */
#include "fidelity_table.h"

#include "fidelity_costs.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>

/* 0 cycles where the benchmark does not measure */
static step_cost_t costs[MODELS];

bool fidelity_table_prepare(void)
{
    for (int i = 0; i < MODELS; i++) {
        const measured_t measured = model_measured((model_t)i);
        costs[i] = (step_cost_t){measured.variant, measured.rule, 0};
    }
    return step_costs_read(costs, MODELS, EPF_BENCH_BASELINE);
}

static void print_header(int motion, int first, int end)
{
    (void)printf("| %s | cycles |", fidelity_motion_name(motion));
    for (int i = first; i < end; i++) {
        (void)printf(" %s |", trigger_name(i));
    }
    (void)printf("\n|---|--:|");
    for (int i = first; i < end; i++) {
        (void)printf("--:|");
    }
    (void)putchar('\n');
}

static void print_cycles(model_t model)
{
    if (costs[model].cycles > 0) {
        (void)printf(" %lu |", costs[model].cycles);
    } else {
        (void)printf("  |");
    }
}

/* No estimate that stays between -z_max and z_max is off by more than 2 z_max */
static void print_error(double rms, double largest)
{
    if (isnan(rms)) {
        (void)printf(" no number |");
    } else if (largest > 2.0) {
        (void)printf(" diverges |");
    } else {
        (void)printf(" %.1e (%.0e) |", rms, largest);
    }
}

static void print_table(const fidelity_t *fidelity, int motion, int first, int end)
{
    print_header(motion, first, end);
    for (int i = 0; i < MODELS; i++) {
        const model_t model = (model_t)i;
        (void)printf("| %s |", model_name(model));
        print_cycles(model);
        for (int trigger = first; trigger < end; trigger++) {
            print_error(fidelity_rms(fidelity, trigger, model),
                        fidelity_largest(fidelity, trigger, model));
        }
        (void)putchar('\n');
    }
    (void)putchar('\n');
}

void fidelity_print(const fidelity_t *fidelity, int motion)
{
    print_table(fidelity, motion, 0, SPACINGS);
    print_table(fidelity, motion, SPACINGS, TRIGGERS);
}
