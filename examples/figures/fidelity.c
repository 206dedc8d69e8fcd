/* SPDX-License-Identifier: MIT */
/*
 * The fidelity benchmark: how close each model comes to the continuous one, at the updates, over the
 * distance and over the time between them. It is no figure of the paper.
 */
#include "fidelity_run.h"
#include "fidelity_step.h"
#include "fidelity_table.h"
#include "figure.h"
#include "larger.h"

#include <math.h>

enum { VARIANTS = 3 }; /* f32, q31, q15 */
static const model_t mean_value[VARIANTS] = {MODEL_MEAN_VALUE_F32, MODEL_MEAN_VALUE_Q31,
                                             MODEL_MEAN_VALUE_Q15};
static const model_t saturated[VARIANTS] = {MODEL_SATURATED_F32, MODEL_SATURATED_Q31,
                                            MODEL_SATURATED_Q15};

/* rms error of one over that of the other */
static double times(const fidelity_t *fidelity, int trigger, model_t one, model_t other)
{
    return fidelity_rms(fidelity, trigger, one) / fidelity_rms(fidelity, trigger, other);
}

static void write_csv(FILE *csv, const fidelity_t *fidelity, int motion)
{
    for (int i = 0; i < MODELS; i++) {
        const model_t model = (model_t)i;
        for (int trigger = 0; trigger < TRIGGERS; trigger++) {
            (void)fprintf(csv, "%s,%s,%s,%g,%.3e,%.3e\n", fidelity_motion_name(motion),
                          model_name(model), trigger_name(trigger), trigger_value(trigger),
                          fidelity_rms(fidelity, trigger, model),
                          fidelity_largest(fidelity, trigger, model));
        }
    }
}

/* ---- what the motions pass through ------------------------------------------------------------ */

static void claim_passage(claims_t *claims, const fidelity_t fidelity[MOTIONS])
{
    regimes_claim(&fidelity[START_AND_STOP].regimes, REGIMES, claims,
                  "start and stop: updates at D_x = 0.1 um");
    claim_at_most(claims, regimes_percent(&fidelity[SHAKEN].regimes, REGIME_CASE_1), 5.0, "%",
                  "shaken: updates at D_x = %s that find the contact in case 1",
                  trigger_name(AT_100_NM));
    for (int motion = 0; motion < MOTIONS; motion++) {
        claim_at_most(claims, fidelity[motion].apart / 1e-12, 2.0, "pm",
                      "%s: half the step moves z by no more than", fidelity_motion_name(motion));
    }
}

/* ---- how close the mean-value rule comes ------------------------------------------------------ */

static void claim_closeness(claims_t *claims, const fidelity_t *fidelity, int motion)
{
    for (int i = 0; i < VARIANTS; i++) {
        double most = 0.0;
        for (int trigger = AT_10_NM; trigger <= AT_5_UM; trigger++) {
            most = larger(most, times(fidelity, trigger, mean_value[i], MODEL_EXACT_FLOW));
        }
        claim_at_most(claims, most, 1.05, "",
                      "%s, %s: rms error over that of the exact flow, the most from 10 nm to 5 um",
                      fidelity_motion_name(motion), model_name(mean_value[i]));
    }
}

/* Where the steps are so short that only the arithmetic is left, or the rule's own error shows */
static void claim_floor(claims_t *claims, const fidelity_t fidelity[MOTIONS])
{
    static const double limits[VARIANTS] = {1e-6, 1e-6, 5e-5};
    for (int i = 0; i < VARIANTS; i++) {
        claim_at_most(claims, fidelity_rms(&fidelity[START_AND_STOP], AT_20_KHZ, mean_value[i]),
                      limits[i], "z_max", "start and stop, 20 kHz, %s: rms error",
                      model_name(mean_value[i]));
    }
    claim_at_most(claims,
                  times(&fidelity[SHAKEN], AT_20_KHZ, MODEL_MEAN_VALUE_F32, MODEL_EXACT_FLOW), 3.0,
                  "", "shaken, 20 kHz, mean value f32: rms error over that of the exact flow");
}

/* Of all variants, the one that the mean-value rule serves least */
static double least_gain(const fidelity_t *fidelity, int trigger)
{
    double least = HUGE_VAL;
    for (int i = 0; i < VARIANTS; i++) {
        least = smaller(least, times(fidelity, trigger, saturated[i], mean_value[i]));
    }
    return least;
}

static void claim_gain(claims_t *claims, const fidelity_t *fidelity, int motion)
{
    static const struct {
        int trigger;
        double at_least[MOTIONS];
    } gains[] = {{AT_10_NM, {70.0, 5.0}},
                 {AT_100_NM, {8.0, 1.5}},
                 {AT_1_UM, {1.6, 1.1}},
                 {AT_5_UM, {1.2, 1.1}},
                 {AT_1_KHZ, {25.0, 10.0}}};
    for (unsigned i = 0; i < sizeof gains / sizeof gains[0]; i++) {
        claim_at_least(claims, least_gain(fidelity, gains[i].trigger), gains[i].at_least[motion],
                       "",
                       "%s, %s: rms error of saturated over mean value, the least of f32, q31, q15",
                       fidelity_motion_name(motion), trigger_name(gains[i].trigger));
    }
}

/* ---- what else one could do ------------------------------------------------------------------- */

static void claim_velocity(claims_t *claims, const fidelity_t *fidelity, int motion)
{
    claim_at_least(
        claims, times(fidelity, AT_1_KHZ, MODEL_END_VELOCITY, MODEL_MEAN_VALUE_F32), 15.0, "",
        "%s, 1 kHz, mean value f32: rms error with the velocity at the end of a step over "
        "that with its mean",
        fidelity_motion_name(motion));
}

static void claim_rivals(claims_t *claims, const fidelity_t fidelity[MOTIONS])
{
    static const double limits[MODELS] = {[MODEL_AS_PRINTED] = 100.0,
                                          [MODEL_EP_EULER] = 10.0,
                                          [MODEL_LUGRE_EULER] = 300.0,
                                          [MODEL_LUGRE_EXACT] = 300.0};
    for (int i = MODEL_AS_PRINTED; i < MODELS; i++) {
        claim_at_least(
            claims, times(&fidelity[START_AND_STOP], AT_1_KHZ, (model_t)i, MODEL_MEAN_VALUE_F32),
            limits[i], "", "start and stop, 1 kHz: rms error of %s over that of mean value f32",
            model_name((model_t)i));
    }
    for (int i = MODEL_EP_EULER; i <= MODEL_LUGRE_EULER; i++) {
        claim_at_least(claims, fidelity_largest(&fidelity[SHAKEN], AT_100_HZ, (model_t)i), 2.0,
                       "z_max", "shaken, 100 Hz: %s diverges: largest error",
                       model_name((model_t)i));
    }
}

void figure_fidelity(FILE *csv, claims_t *claims)
{
    static fidelity_t fidelity[MOTIONS]; /* too large for some stacks */
    (void)fputs("motion,model,trigger,m_or_Hz,rms_z_max,largest_z_max\n", csv);
    for (int motion = 0; motion < MOTIONS; motion++) {
        fidelity_run(&fidelity[motion], motion);
        write_csv(csv, &fidelity[motion], motion);
        fidelity_print(&fidelity[motion], motion);
    }
    claim_passage(claims, fidelity);
    for (int motion = 0; motion < MOTIONS; motion++) {
        claim_closeness(claims, &fidelity[motion], motion);
    }
    claim_floor(claims, fidelity);
    for (int motion = 0; motion < MOTIONS; motion++) {
        claim_gain(claims, &fidelity[motion], motion);
        claim_velocity(claims, &fidelity[motion], motion);
    }
    claim_rivals(claims, fidelity);
    fidelity_claim_steps(claims);
}
