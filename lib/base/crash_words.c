#include "base/crash_words.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int crash_places(const char *text, SourcePlace *places, int most)
{
    int count = 0;
    while (count < most && *text) {
        // What the compiler made of a function has a point in its name: reflect.part.0.
        size_t name = strcspn(text, ".\n"), first = strcspn(text, "\n");
        const char *path = text + first + (text[first] == '\n');
        const char *end = path + strcspn(path, "\n"), *colon = end;
        while (colon > path && *colon != ':')
            colon--;
        const char *file = colon;
        while (file > path && file[-1] != '/')
            file--;
        SourcePlace *place = &places[count];
        place->line = *colon == ':' ? atoi(colon + 1) : 0;
        snprintf(place->function, sizeof place->function, "%.*s", (int)(name < 100 ? name : 100), text);
        snprintf(place->file, sizeof place->file, "%.*s", (int)(colon - file < 200 ? colon - file : 200), file);
        count += text[0] != '?';
        text = end + (*end == '\n');
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
