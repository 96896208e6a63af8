#include "base/crash_words.h"
#include "base/file.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int crash_places(const char *text, SourcePlace *places, int most)
{
    int count = 0, used;
    char function[1024], path[4096];
    for (; count < most && sscanf(text, "%1023[^\n] %4095[^\n] %n", function, path, &used) == 2; text += used) {
        SourcePlace *place = &places[count];
        char *colon = strrchr(path, ':'), *slash;
        place->line = colon ? atoi(colon + 1) : 0;
        if (colon)
            *colon = '\0';
        slash = strrchr(path, '/');
        // What the compiler made of a function has a point in its name: reflect.part.0.
        snprintf(place->function, sizeof place->function, "%.*s", (int)strcspn(function, "."), function);
        snprintf(place->file, sizeof place->file, "%.200s", slash ? slash + 1 : path);
        count += function[0] != '?' && !file_ends_in(place->file, ".h");
    }
    return count;
}

void crash_describe_signal(int number, unsigned long long address, const char *place, char *text, size_t size)
{
    if (number == SIGSEGV || number == SIGBUS)
        snprintf(text, size, "segmentation fault%s: an address that is not yours%s", place,
                 address < 4096 ? " (a null pointer, or an index far beyond an array?)"
                                : " (beyond the end of an array?)");
    else if (number == SIGFPE)
        snprintf(text, size, "an integer was divided by 0%s", place);
    else
        snprintf(text, size, "it came to a place that right code never reaches%s (signal %d)", place, number);
}

void crash_describe_stack(const char *function, const char *caller, char *text, size_t size)
{
    if (caller)
        snprintf(text, size, "the stack overflowed: %s calls itself without end", caller);
    else // compilers make room for arrays on different lines
        snprintf(text, size, "the stack overflowed%s%s: a very large array, or calls without end?",
                 function ? " in " : "", function ? function : "");
}
