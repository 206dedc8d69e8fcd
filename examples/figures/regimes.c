/* SPDX-License-Identifier: MIT */
#include "regimes.h"

static const char *const names[REGIMES] = {"elastic", "mixed", "sliding", "in case 1"};

static regime_t regime_of(const friction_t *friction, double z, double v)
{
    const double zeta = v < 0.0 ? -z : z;
    const double z_ss = friction_z_ss(friction, v);
    if (zeta <= friction->z_ba) {
        return REGIME_ELASTIC;
    }
    if (zeta > z_ss) {
        return REGIME_CASE_1;
    }
    return zeta > 0.95 * z_ss ? REGIME_SLIDING : REGIME_MIXED;
}

void regimes_add(regimes_t *regimes, const friction_t *friction, double z, double v)
{
    regimes->found[regime_of(friction, z, v)]++;
}

double regimes_percent(const regimes_t *regimes, regime_t regime)
{
    double all = 0.0;
    for (int i = 0; i < REGIMES; i++) {
        all += (double)regimes->found[i];
    }
    return 100.0 * (double)regimes->found[regime] / all;
}

void regimes_claim(const regimes_t *regimes, regime_t end, claims_t *claims, const char *of)
{
    for (int i = 0; i < (int)end; i++) {
        claim_at_least(claims, regimes_percent(regimes, (regime_t)i), 5.0, "%",
                       "%s that find the contact %s", of, names[i]);
    }
}
