#include "photons/pass/oddities.h"
#include "base/text.h"
#include "steps/2_glossy_lobe.h"

#include <math.h>
#include <stdio.h>

// From fewer paths the standard error itself is too uncertain to judge by: of one path it is 0, and of a hundred it is
// still far too small now and then.
#define FEWEST_PATHS 1000

// Which steps give directions at which surface; where none of those is the student's, the loops are suspected.
static const struct {
    const char *place, *steps;
} sources[MATERIAL_TYPES] = {
    [MATERIAL_DIFFUSE] = {.place = "a diffuse surface", .steps = "1.3"},
    [MATERIAL_GLOSSY] = {.place = "a glossy surface", .steps = "1.3 2.1 2.2 2.3 2.4"},
    [MATERIAL_MIRROR] = {.place = "a mirror", .steps = "1.1"},
    [MATERIAL_GLASS] = {.place = "glass", .steps = "1.1 3.1"},
    [MATERIAL_LIGHT] = {.place = "the light", .steps = "1.2 1.3"},
};
#define LOOPS   "1.5 3.4 6.4"
#define WEIGHTS "1.4 1.5 2.1 2.2 2.3 2.4 3.1 3.2 3.3 3.4 3.5 6.1 6.2 6.4" // decide power, or who goes on

// "your step 1.3 (scatter_diffuse)", "one of your steps 1.3, 2.4"; false: none of these is the student's.
static bool name_suspects(const char *ids, const StepState *states, char *text, size_t size)
{
    const StepInfo *only = NULL;
    char list[64] = "";
    int count = 0;
    for (size_t i = 0; i < STEP_COUNT; i++)
        if (states[i] == STEP_STUDENT && step_is_listed(ids, step_table[i].id)) {
            only = &step_table[i];
            text_append(list, sizeof list, "%s%s", count++ > 0 ? ", " : "", only->id);
        }
    if (count == 1)
        snprintf(text, size, "your step %s (%s)", only->id, only->symbol);
    else
        snprintf(text, size, "one of your steps %s", list);
    return count > 0;
}

static void describe_unsound(const UnsoundPaths *unsound, const StepState *states, char *text, size_t size)
{
    int most = 0;
    for (int i = 1; i < MATERIAL_TYPES; i++)
        if (unsound->at[i] > unsound->at[most])
            most = i;
    char who[96], length[32] = "no number (NaN)";
    if (!name_suspects(sources[most].steps, states, who, sizeof who) && !name_suspects(LOOPS, states, who, sizeof who))
        snprintf(who, sizeof who, "a step");
    if (!isnan(unsound->length))
        snprintf(length, sizeof length, "%.3g", (double)unsound->length);
    char share[48] = "";
    if (unsound->at[most] < unsound->total)
        snprintf(share, sizeof share, ", %ld of them", unsound->at[most]);
    text_append(text, size, "%ld paths ended%s at %s: %s gave a direction whose length is %s, not 1\n", unsound->total,
                share, sources[most].place, who, length);
}

static void describe_energy(const Ledger *ledger, const StepState *states, char *text, size_t size)
{
    static const char *const names[] = {"red", "green", "blue"};
    char who[96];
    if (!name_suspects(WEIGHTS, states, who, sizeof who))
        snprintf(who, sizeof who, "the steps");
    for (int c = 0; c < 3; c++) {
        double chance = ledger->chance[c], error = ledger->chance_error[c];
        // Rounding alone moves the sum by a millionth.
        if (fabs(chance) <= 5.0 * error + 1e-6 * ledger->emitted[c])
            continue;
        if (isfinite(chance))
            text_append(text, size,
                        "energy: of %.4g W of %s light, bounces %s %.4g W for no reason, where 0 ± %.2g is right. A "
                        "weight or probability is off, or does not fit its directions: look at %s\n",
                        ledger->emitted[c], names[c], chance < 0.0 ? "gained" : "lost", fabs(chance), error, who);
        else
            text_append(text, size, "energy: a photon's power is no number (NaN), or infinite: look at %s\n", who);
        return;
    }
}

void oddities_describe(const Oddities *found, char *text, size_t size)
{
    text[0] = '\0';
    if (found->redraw_caps > 0)
        text_append(text, size, "step 2.3: %ld photons were dropped after %d redraws of the lobe\n", found->redraw_caps,
                    MAX_LOBE_TRIES);
    if (found->unsound->total > 0)
        describe_unsound(found->unsound, found->states, text, size);
    // Where paths ended by a bad direction, their flux is missing too, and no weight is to blame.
    if (found->paths >= FEWEST_PATHS && found->unsound->total == 0)
        describe_energy(found->ledger, found->states, text, size);
}
