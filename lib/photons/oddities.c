#include "photons/oddities.h"
#include "steps/2_glossy_lobe.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

// The spread of fewer paths is itself too uncertain to accuse anybody: of one path it is 0, whatever chance did, and of
// a hundred it is still too small now and then.
#define FEWEST_PATHS 1000

static void describe_energy(const Ledger *ledger, char *text, size_t size)
{
    static const char *const names[] = {"red", "green", "blue"};
    for (int c = 0; c < 3; c++) {
        double error = ledger->chance_error[c];
        // Rounding alone moves the sum by a millionth.
        if (fabs(ledger->chance[c]) <= 5.0 * error + 1e-6 * ledger->emitted[c])
            continue;
        snprintf(text, size,
                 "energy: of %.4g W of %s light, bounces won %.4g W by chance, where 0 ± %.2g is right. A step's "
                 "weight or probability is off\n",
                 ledger->emitted[c], names[c], -ledger->chance[c], error);
        return;
    }
}

void oddities_describe(const Ledger *ledger, long paths, long unsound, long redraw_caps, char *text, size_t size)
{
    text[0] = '\0';
    size_t used = 0;
    if (redraw_caps > 0)
        snprintf(text, size, "step 2.3: %ld photons were dropped after %d redraws of the lobe\n", redraw_caps,
                 MAX_LOBE_TRIES);
    used = strlen(text);
    if (unsound > 0)
        snprintf(text + used, size - used,
                 "%ld paths ended since a step gave a direction that is not of unit length (NaN, say)\n", unsound);
    used = strlen(text);
    if (paths >= FEWEST_PATHS)
        describe_energy(ledger, text + used, size - used);
}
