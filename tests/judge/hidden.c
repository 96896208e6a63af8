#include "judge/judge.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

// What gives the solutions away. Bubblewrap does not show it; a user of its own could read what is open to all.
static void hide(GradeOptions *g)
{
    const struct {
        const char *folder, *name;
    } secrets[] = {{g->root, "solutions"},      {g->root, "tests/alternatives"},
                   {g->root, "tests/mistakes"}, {g->root, "tests/attacks"},
                   {g->root, ".git"},           {g->build, "solutions"},
                   {g->build, "obj/solutions"}};
    int count = 0;
    // Others' work, in a class: folders parted by colons.
    const char *others = getenv("PHOTONLAB_HIDDEN");
    for (const char *at = others ? others : ""; *at && count < MOST_HIDDEN - 8; at += *at == ':') {
        size_t length = strcspn(at, ":");
        if (length > 0)
            g->hidden[count++] = strndup(at, length);
        at += length;
    }
    for (size_t i = 0; i < sizeof secrets / sizeof *secrets; i++) {
        char path[4200];
        struct stat state;
        snprintf(path, sizeof path, "%s/%s", secrets[i].folder, secrets[i].name);
        if (stat(path, &state) == 0)
            g->hidden[count++] = strdup(path);
    }
}

// Without credit a student's own run goes on, and says what it cannot promise.
static void warn_of_open_solutions(GradeOptions *g)
{
    struct stat state;
    for (int i = 0; g->hidden[i]; i++) {
        if (stat(g->hidden[i], &state) != 0 || !(state.st_mode & (S_IROTH | S_IXOTH)))
            continue;
        fprintf(stderr, "── The code could read %s. Fine for your own; grading for credit refuses.\n", g->hidden[i]);
        for (int j = 0; g->hidden[j]; j++)
            free(g->hidden[j]);
        memset(g->hidden, 0, sizeof g->hidden);
        return;
    }
}

// Before grading for credit, as root: what others could read is closed to them, and stays closed.
static void close_solutions(const GradeOptions *g)
{
    struct stat state;
    for (int i = 0; g->hidden[i]; i++)
        if (stat(g->hidden[i], &state) == 0 && (state.st_mode & (S_IRWXG | S_IRWXO)) &&
            chmod(g->hidden[i], state.st_mode & S_IRWXU) == 0)
            fprintf(stderr, "── %s was open to others; now it is not.\n", g->hidden[i]);
}

bool choose_sandbox(Arguments *a)
{
    char reason[512] = "";
    a->grade.sandbox = sandbox_open(reason, sizeof reason);
    hide(&a->grade);
    if (a->grade.sandbox == SANDBOX_UID && a->credit)
        close_solutions(&a->grade);
    else if (a->grade.sandbox == SANDBOX_UID)
        warn_of_open_solutions(&a->grade);
    if (a->grade.sandbox != SANDBOX_NONE)
        return true;
    fprintf(stderr, "%s NO SANDBOX: %s\n", a->credit ? "judge:" : "──", reason);
    if (!a->credit)
        fprintf(stderr, "── The code runs with your rights. Fine for your own; do not run anyone else's like this.\n");
    return !a->credit;
}
