// What the judge's reader of object files sees in one: object_names FILE…; 1 when one is none.
#include "judge/submission/object_file.h"

#include <stdio.h>

int main(int count, char **arguments)
{
    static const char *const kinds[] = {"wants", "function", "private", "variable", "at-load"};
    int code = 0;
    for (int i = 1; i < count; i++) {
        ObjectFile object;
        Error error = {""};
        if (!object_read(arguments[i], &object, &error)) {
            fprintf(stderr, "%s\n", error.message);
            code = 1;
            continue;
        }
        for (size_t s = 0; s < object.count; s++)
            printf("%s %s\n", kinds[object.symbols[s].kind], object.symbols[s].name);
        if (object.keeps_data)
            puts("keeps-data");
        if (object.runs_at_load)
            puts("runs-at-load");
        object_free(&object);
    }
    return code;
}
