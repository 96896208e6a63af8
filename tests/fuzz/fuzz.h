// What the fuzzers share. Each is a file fuzz_NAME.c, fed with whatever libFuzzer thinks of, and a row of seeds in fuzz.sh.
#pragma once

#include <signal.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static inline void require(bool condition)
{
    if (!condition)
        abort();
}

// After FUZZ_SECONDS of a processor libFuzzer gets the signal at which it tells what it did and ends. Its own limit counts the wall's.
__attribute__((constructor)) static void fuzz_until(void)
{
    const char *seconds = getenv("FUZZ_SECONDS");
    if (!seconds)
        return; // one input again, by hand
    struct sigevent event = {.sigev_notify = SIGEV_SIGNAL, .sigev_signo = SIGUSR1};
    struct itimerspec time = {.it_value = {.tv_sec = atol(seconds)}};
    timer_t timer;
    require(time.it_value.tv_sec > 0); // else it would never end
    require(timer_create(CLOCK_PROCESS_CPUTIME_ID, &event, &timer) == 0 && timer_settime(timer, 0, &time, NULL) == 0);
}

// A folder of this process's own; libFuzzer ends without a word to us, so fuzz.sh gives it a TMPDIR that it removes.
static inline const char *fuzz_folder(void)
{
    static char folder[256];
    const char *temporary = getenv("TMPDIR");
    if (!folder[0]) {
        snprintf(folder, sizeof folder, "%s/fuzz-XXXXXX", temporary ? temporary : "/tmp");
        require(mkdtemp(folder) != NULL);
    }
    return folder;
}

// The bytes as a file of this name there; its path.
static inline const char *fuzz_file(const char *name, const uint8_t *data, size_t size)
{
    static char path[512];
    snprintf(path, sizeof path, "%s/%s", fuzz_folder(), name);
    FILE *file = fopen(path, "wb");
    require(file && fwrite(data, 1, size, file) == size && fclose(file) == 0);
    return path;
}

// The bytes as text, with a 0 behind them, so that reading on is seen. To be freed.
static inline char *fuzz_text(const uint8_t *data, size_t size)
{
    char *text = malloc(size + 1);
    require(text != NULL);
    memcpy(text, data, size);
    text[size] = '\0';
    return text;
}
