#include "web/serve/serve.h"
#include "base/file.h"
#include "base/text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>

#define MOST_BYTES (1u << 28) // of an object, of a module

// A stub calls todo(): its object names this.
static const char STUB[] = "photonlab_step_not_started";

static bool holds(const char *bytes, size_t size, const char *word)
{
    size_t length = strlen(word);
    for (const char *at = bytes; (at = memchr(at, word[0], size - (size_t)(at - bytes))); at++)
        if (size - (size_t)(at - bytes) >= length && memcmp(at, word, length) == 0)
            return true;
    return false;
}

static void object_path(const Tab *tab, size_t i, char path[4096])
{
    snprintf(path, 4096, "%s/%s.so", tab->options->objects, step_table[i].file);
}

static void look_at_objects(Tab *tab)
{
    char path[4096];
    for (size_t i = 0; i < STEP_COUNT; i++) {
        size_t size;
        object_path(tab, i, path);
        char *bytes = file_read(path, MOST_BYTES, &size, NULL);
        tab->states[i] = !bytes ? STEP_REFERENCE : holds(bytes, size, STUB) ? STEP_NOT_STARTED : STEP_STUDENT;
        free(bytes);
    }
}

static bool begin_link(Tab *tab)
{
    static char paths[STEP_COUNT][4096];
    const char *arguments[STEP_COUNT + 6] = {"/bin/sh", "-c", tab->options->link, "sh", tab->module};
    int count = 5;
    look_at_objects(tab);
    coach_note_states(&tab->coach, tab->states);
    for (size_t i = 0; i < STEP_COUNT; i++)
        if (tab->states[i] == STEP_STUDENT) {
            object_path(tab, i, paths[i]);
            arguments[count++] = paths[i];
        }
    tab->link_wanted = false;
    process_kill(&tab->linker);
    tab->said_size = 0;
    tab->said[0] = '\0';
    return process_start(&tab->linker, arguments, PRINTS_ALL);
}

// The linker's words, said of sources.
static void describe_link(Tab *tab)
{
    const char *missing = strstr(tab->said, "undefined symbol: ");
    for (size_t i = 0; missing && i < STEP_COUNT; i++) {
        const char *object = strstr(tab->said, step_table[i].file);
        if (!object || object > missing)
            continue;
        fault_describe_missing(tab->options->source, &step_table[i], missing + strlen("undefined symbol: "),
                               tab->link_failure, sizeof tab->link_failure);
        return;
    }
    const char *error = strstr(tab->said, "error: ");
    error = error ? error : tab->said;
    snprintf(tab->link_failure, sizeof tab->link_failure, "your steps do not link: %.*s", (int)strcspn(error, "\n"),
             error);
}

static void take_module(Tab *tab)
{
    Error error = {""};
    size_t size;
    char *bytes = file_read(tab->module, MOST_BYTES, &size, &error);
    if (!bytes) {
        snprintf(tab->link_failure, sizeof tab->link_failure, "%.500s", error.message);
        return;
    }
    free(tab->bytes);
    tab->bytes = bytes;
    tab->size = size;
    tab->module_number++;
    tab->failure[0] = tab->link_failure[0] = tab->students[0] = '\0';
    process_kill(&tab->looker); // of a module that is gone
    for (size_t i = 0; i < STEP_COUNT; i++)
        if (tab->states[i] == STEP_STUDENT)
            text_append(tab->students, sizeof tab->students, "%s%s", tab->students[0] ? " " : "", step_table[i].id);
}

static bool poll_link(Tab *tab)
{
    int status;
    if (tab->link_wanted && !begin_link(tab))
        return false;
    process_read(&tab->linker, tab->said, sizeof tab->said, &tab->said_size);
    if (!process_has_ended(&tab->linker, &status))
        return false;
    process_read(&tab->linker, tab->said, sizeof tab->said, &tab->said_size);
    process_kill(&tab->linker);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0)
        take_module(tab);
    else
        describe_link(tab);
    if (tab->link_failure[0])
        puts(tab->link_failure);
    return true;
}

static bool poll_watch(Tab *tab)
{
    WatchEvent event = watch_poll(tab->watch);
    if (event == WATCH_NOTHING)
        return false;
    tab->building = event == WATCH_BUILDING;
    if (tab->building)
        return true;
    snprintf(tab->build, sizeof tab->build, "%s", watch_message(tab->watch));
    puts(tab->build);
    if (event == WATCH_FAILED) {
        coach_note_broken(&tab->coach, watch_step(tab->watch), tab->build);
        return true;
    }
    snprintf(tab->warning, sizeof tab->warning, "%s", watch_warning(tab->watch));
    if (tab->warning[0])
        puts(tab->warning);
    tab->link_wanted = true;
    coach_judge(&tab->coach, watch_step(tab->watch));
    return true;
}

bool tab_start(Tab *tab, const TabOptions *options, Error *error)
{
    *tab =
        (Tab){.options = options, .stage = options->stage, .linker = {0, -1}, .looker = {0, -1}, .link_wanted = true};
    snprintf(tab->scene, sizeof tab->scene, "%s", options->scene);
    snprintf(tab->module, sizeof tab->module, "%s/students.wasm", options->objects);
    StepChoice play;
    if (options->steps && !step_choice_parse(options->steps, &play, error))
        return false;
    tab->watch = watch_start(options->source, options->objects, options->build, error);
    coach_start(&tab->coach, options->judge, options->stage, options->stages);
    return tab->watch;
}

void tab_stop(Tab *tab)
{
    process_kill(&tab->linker);
    process_kill(&tab->looker);
    coach_stop(&tab->coach);
    watch_stop(tab->watch);
    free(tab->bytes);
}

bool tab_poll(Tab *tab)
{
    bool news = poll_watch(tab);
    news |= poll_link(tab);
    news |= tab_poll_failure(tab);
    news |= coach_poll(&tab->coach);
    tab->number += news;
    return news;
}

bool tab_is_busy(const Tab *tab)
{
    return tab->building || tab->linker.pid > 0 || tab->looker.pid > 0;
}

void tab_next_step(Tab *tab)
{
    const StepInfo *step = coach_next(&tab->coach);
    if (!step)
        return;
    if (tab->stage > 0 && step->stage != tab->stage) { // each has a scene in which its steps show
        const char *scene = strrchr(stage_scenes[step->stage - 1], '/');
        tab->stage = step->stage;
        snprintf(tab->scene, sizeof tab->scene, "%s", scene ? scene + 1 : stage_scenes[step->stage - 1]);
    }
    printf("the present step: %s/%s.c\n", tab->options->source, step->file);
}
