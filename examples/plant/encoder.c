/* SPDX-License-Identifier: MIT */
#include "encoder.h"

#include <math.h>

double encoder_read(encoder_t *encoder, double x)
{
    if (encoder->noise > 0.0) {
        x += encoder->noise * noise_next(&encoder->source);
    }
    return encoder->resolution > 0.0 ? encoder->resolution * floor(x / encoder->resolution + 0.5)
                                     : x;
}
