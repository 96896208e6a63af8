#include "preview/run/helper.h"
#include "base/process.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

void output_join(const HelperOutput *output)
{
    dup2(output->ends[1], STDOUT_FILENO);
    dup2(output->ends[1], STDERR_FILENO);
    close(output->ends[0]);
    close(output->ends[1]);
}

// How many of these bytes belong to the first lines.
static size_t first_lines(HelperOutput *output, const char *bytes, size_t size)
{
    size_t taken = 0;
    while (taken < size && output->lines < OUTPUT_LINES && output->bytes + taken < OUTPUT_BYTES)
        output->lines += bytes[taken++] == '\n';
    output->bytes += taken;
    return taken;
}

static void sort(HelperOutput *output, const char *bytes, size_t size)
{
    size_t shown = first_lines(output, bytes, size);
    write_all(STDOUT_FILENO, bytes, shown);
    if (shown > 0)
        output->in_line = bytes[shown - 1] != '\n';
    output->more_bytes += size - shown;
    for (size_t i = shown; i < size; i++)
        output->more_lines += bytes[i] == '\n';
}

void output_pass_on(HelperOutput *output)
{
    char bytes[1 << 16];
    for (ssize_t got; (got = read(output->ends[0], bytes, sizeof bytes)) != 0;) {
        if (got > 0)
            sort(output, bytes, (size_t)got);
        else if (errno != EINTR)
            return; // nothing more at present
    }
}

static void tell_rest(HelperOutput *output)
{
    char text[160] = "";
    if (output->more_bytes > 0)
        snprintf(text, sizeof text,
                 "%s… and %ld more lines that your code printed; `make render CODE=exercises` shows all\n",
                 output->in_line ? "\n" : "", output->more_lines);
    else if (output->in_line)
        snprintf(text, sizeof text, "\n");
    write_all(STDOUT_FILENO, text, strlen(text));
}

void output_end(HelperOutput *output)
{
    output_pass_on(output);
    tell_rest(output);
    *output = (HelperOutput){.ends = {output->ends[0], output->ends[1]}};
}
