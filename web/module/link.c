// What the program finds at run time, and the module has from the start: steps, and the functions of OpenGL.
#include "web/module/web.h"

#include "preview/draw/canvas_internal.h"

bool steps_load(const char *student_dir, Error *error)
{
    (void)student_dir, (void)error;
#define STEP(stage, number, symbol, ...) steps.symbol = symbol;
#include "steps/steps.def"
    steps_play((StepChoice){0});
    return true;
}

// The ids of the steps that a student's objects were linked for, parted by blanks.
void EXPORT(web_students)(const char *ids)
{
    for (size_t i = 0; i < STEP_COUNT; i++)
        step_states[i] = step_is_listed(ids, step_table[i].id) ? STEP_STUDENT : STEP_REFERENCE;
}

#define FROM_PAGE(function)                                                                                            \
    extern __typeof__(gl##function) gl##function __attribute__((import_module("env"), import_name("gl" #function)));
GL_FUNCTIONS(FROM_PAGE)

void *web_gl(const char *name)
{
#define ROW(function) {"gl" #function, (void (*)(void))gl##function},
    static const struct {
        const char *name;
        void (*function)(void);
    } TABLE[] = {GL_FUNCTIONS(ROW)};
    void *address = NULL;
    for (size_t i = 0; i < sizeof TABLE / sizeof *TABLE; i++)
        if (strcmp(TABLE[i].name, name) == 0)
            memcpy(&address, &TABLE[i].function, sizeof address);
    return address;
}
