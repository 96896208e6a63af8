// Step 4.5: irradiance by the estimates near a place. Contract: lib/steps/4_final_gathering.h
#include "photonlab.h"

bool interpolate_irradiance(const IrradianceEstimate *const near[], size_t count, Vec3 position, Vec3 normal,
                            float accuracy, Colour *irradiance)
{
    todo("4.5"), (void)near, (void)count, (void)position, (void)normal, (void)accuracy, (void)irradiance; // take this line away when you start

    // 1. How wrong may this one be here? Far away or turned away, it does not serve.

    // 2. Nor does it where the place lies below its surface: it has seen what the place does not see.

    // 3. Weigh what it says of this place.

    // 4. The mean, if any serves.

    return false;
}
