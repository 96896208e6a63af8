#include "preview/record/verdicts.h"

#include <stdio.h>
#include <string.h>

const char *const verdict_marks[VERDICT_STATES] = {"·", "✓", "✗", "!", "○", "–"};

// Of the line's field number i, counted from 0, as much as there is room for.
static void take_field(const char *line, int i, char *text, size_t size)
{
    while (i-- > 0 && *line) {
        line += strcspn(line, "\t");
        line += *line == '\t';
    }
    snprintf(text, size, "%.*s", (int)strcspn(line, "\t\n"), line);
}

const StepInfo *verdicts_take_line(Verdicts *verdicts, const char *line)
{
    static const char *const NAMES[VERDICT_STATES] = {"", "pass", "fail", "error", "todo", "skip"};
    char id[16], name[16];
    take_field(line, 0, id, sizeof id);
    take_field(line, 1, name, sizeof name);
    const StepInfo *step = step_find(id);
    int state = VERDICT_STATES - 1;
    while (state > VERDICT_NONE && strcmp(name, NAMES[state]) != 0)
        state--;
    if (!step || state == VERDICT_NONE)
        return NULL;
    Verdict *verdict = &verdicts->steps[step - step_table];
    *verdict = (Verdict){.state = (VerdictState)state};
    take_field(line, 2, verdict->message, sizeof verdict->message);
    take_field(line, 3, verdict->where, sizeof verdict->where);
    take_field(line, 4, verdict->looks_like, sizeof verdict->looks_like);
    return step;
}

size_t verdicts_next(const Verdicts *verdicts)
{
    for (size_t i = 1; i < verdicts->count; i++) {
        size_t step = (verdicts->present + i) % verdicts->count;
        if (verdicts->steps[step].state != VERDICT_PASS)
            return step;
    }
    return verdicts->present;
}

bool verdicts_all_right(const Verdicts *verdicts)
{
    size_t next = verdicts_next(verdicts);
    return next == verdicts->present && verdicts->steps[next].state == VERDICT_PASS;
}
