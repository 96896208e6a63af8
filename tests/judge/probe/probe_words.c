// A line's words on their way in, numbers on their way out.
#include "judge/probe/probe.h"

#include "base/array.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

void probe_put(ProbeOutput *output, float value)
{
    if (!array_reserve(&output->values, output->count + 1, &output->capacity, sizeof value)) {
        output->out_of_memory = true;
        return;
    }
    output->values[output->count++] = value;
}

void probe_put_vec3(ProbeOutput *output, Vec3 v)
{
    probe_put(output, v.x);
    probe_put(output, v.y);
    probe_put(output, v.z);
}

void probe_put_colour(ProbeOutput *output, Colour c)
{
    probe_put(output, c.r);
    probe_put(output, c.g);
    probe_put(output, c.b);
}

const char *probe_word(ProbeLine *line)
{
    char *word = line->rest + strspn(line->rest, " ");
    size_t length = strcspn(word, " ");
    line->broken = line->broken || length == 0;
    line->rest = word + length + (word[length] != '\0');
    word[length] = '\0';
    return word;
}

double probe_number(ProbeLine *line)
{
    const char *word = probe_word(line);
    char *end;
    double value = strtod(word, &end);
    line->broken = line->broken || end == word || *end;
    return value;
}

long probe_whole(ProbeLine *line, long low, long high)
{
    const char *word = probe_word(line);
    char *end;
    errno = 0;
    long value = strtol(word, &end, 10);
    line->broken = line->broken || end == word || *end || errno || value < low || value > high;
    return value;
}

uint64_t probe_seed(ProbeLine *line)
{
    const char *word = probe_word(line);
    char *end;
    errno = 0;
    uint64_t value = strtoull(word, &end, 10);
    line->broken = line->broken || end == word || *end || errno;
    return value;
}

Vec3 probe_vec3(ProbeLine *line)
{
    float x = (float)probe_number(line);
    float y = (float)probe_number(line);
    float z = (float)probe_number(line);
    return vec3(x, y, z);
}

Colour probe_colour(ProbeLine *line)
{
    Vec3 v = probe_vec3(line);
    return colour(v.x, v.y, v.z);
}

bool probe_at_end(ProbeLine *line)
{
    return line->rest[strspn(line->rest, " ")] == '\0';
}

bool probe_same_again(const ProbeOutput *first, const ProbeOutput *again, Error *error)
{
    bool same = first->count == again->count;
    return (same && (first->count == 0 || memcmp(first->values, again->values, first->count * sizeof(float)) == 0)) ||
           error_set(error, PROBE_NOT_AGAIN);
}
