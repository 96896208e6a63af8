// A probe's last words, and what addr2line says of them (what stands behind a zero byte): a sentence for the student. The
// sandbox is not asked: its run is played here.
#include "fuzz/fuzz.h"
#include "judge/grade/grade.h"

static const char *places;

bool sandbox_run(SandboxKind kind, const SandboxRun *run, SandboxResult *result, Error *error)
{
    (void)kind, (void)error;
    for (int i = 0; run->arguments[i]; i++)
        require(strlen(run->arguments[i]) < 4096);
    *result = (SandboxResult){.exit_code = 0};
    snprintf(result->text, sizeof result->text, "%s", places);
    return true;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static SandboxResult ran;
    static StepWords words;
    char *text = fuzz_text(data, size);
    size_t length = strlen(text);
    places = length < size ? text + length + 1 : "";
    GradeOptions options = {.work = "work"};
    int ends[] = {-1, 0, 1, 77, 11, 6, 8, 9, 24, 31};
    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++) {
        ran = (SandboxResult){.exit_code = i < 4 ? ends[i] : -1, .signal = i < 4 ? 0 : ends[i]};
        snprintf(ran.text, sizeof ran.text, "%s", text);
        memset(&words, 0, sizeof words);
        crash_describe(&options, &ran, i % 2 ? &step_table[0] : NULL, &words);
        require(words.message[0] && memchr(words.message, '\0', sizeof words.message) &&
                memchr(words.where, '\0', sizeof words.where));
    }
    free(text);
    return 0;
}
