// The state of a tab, as the page reads it.
#include "web/serve/serve.h"

#include <jansson.h>
#include <stdlib.h>
#include <string.h>

// Compilers and students write what they like; what is not UTF-8 becomes '?'.
static json_t *text(const char *words)
{
    json_t *string = json_string(words);
    char *copy = string ? NULL : malloc(strlen(words) + 1);
    if (!copy)
        return string;
    strcpy(copy, words);
    for (char *at = copy; *at; at++)
        if ((unsigned char)*at >= 0x80)
            *at = '?';
    string = json_string(copy);
    free(copy);
    return string;
}

static json_t *step(const Tab *tab, size_t i)
{
    static const char *const STATES[VERDICT_STATES] = {"none", "pass", "fail", "error", "todo", "skip"};
    const StepInfo *info = &step_table[i];
    const Verdict *verdict = &tab->coach.verdicts.steps[i];
    return json_pack("{s:s, s:i, s:s, s:s, s:s, s:s, s:b, s:b, s:o, s:o, s:o}", "id", info->id, "stage", info->stage,
                     "title", info->title, "file", info->file, "state", STATES[verdict->state], "mark",
                     verdict_marks[verdict->state], "old", verdict->old, "judged", verdict->judged_now, "message",
                     text(verdict->message), "where", text(verdict->where), "like", text(verdict->looks_like));
}

char *tab_state(const Tab *tab)
{
    const Verdicts *verdicts = &tab->coach.verdicts;
    json_t *steps_now = json_array();
    for (size_t i = 0; i < verdicts->count; i++)
        json_array_append_new(steps_now, step(tab, i));
    const StepInfo *saved = watch_step(tab->watch);
    const char *broken = watch_broken(tab->watch);
    const char *fault = broken[0] ? broken : tab->link_failure[0] ? tab->link_failure : tab->failure;
    json_t *state = json_pack("{s:I, s:i, s:s, s:o, s:o, s:o, s:b, s:o, s:o, s:s, s:s, s:b, s:i, s:s, s:b, s:o, s:o}",
                              "number", (json_int_t)tab->number, "module", tab->module_number, "students",
                              tab->students, "fault", text(fault), "warning", text(tab->warning), "build",
                              text(tab->build), "building", tab->building, "scene", text(tab->scene), "source",
                              text(tab->options->source), "play", tab->options->steps ? tab->options->steps : "",
                              "saved", saved ? saved->id : "", "judged", tab->coach.judging != NULL, "present",
                              (int)verdicts->present, "next", step_table[verdicts_next(verdicts)].id, "finished",
                              verdicts_all_right(verdicts), "hint", text(verdicts->hint), "steps", steps_now);
    char *json = state ? json_dumps(state, JSON_COMPACT) : NULL;
    json_decref(state);
    return json;
}
