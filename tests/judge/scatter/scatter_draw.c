// A stage's scatter as a picture: the student's photons and the reference's, side by side. The program that draws them
// reads photons from files and runs nobody's code.
#include "judge/scatter/scatter.h"
#include "base/process.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#define PATIENCE 20.0 // s

// The program's last words are the reason when it ends with anything but 0.
static bool run_preview(const char *const *words, Error *error)
{
    Process preview;
    char said[400] = "";
    size_t used = 0;
    int status = 1;
    double start = clock_seconds();
    bool ended = false;
    if (!process_start(&preview, words, PRINTS_ERRORS))
        return error_set(error, "the preview could not be run: %s", strerror(errno));
    while (!ended && clock_seconds() - start < PATIENCE) {
        process_read(&preview, said, sizeof said, &used);
        nanosleep(&(struct timespec){0, 5000000}, NULL);
        ended = process_has_ended(&preview, &status);
    }
    process_read(&preview, said, sizeof said, &used);
    process_kill(&preview);
    if (ended && WIFEXITED(status) && WEXITSTATUS(status) == 0)
        return true;
    return error_set(error, "%.*s", (int)strcspn(said, "\n"), *said ? said : "the preview could not be run");
}

static bool write_photons(const ScatterPhotons *photons, const char *path, Error *error)
{
    return photon_numbers_write(path, &photons->head, photons->items, (size_t)photons->count, error);
}

static bool draw(const GradeOptions *options, const char *directory, StageResult *result, Error *error)
{
    char program[4200], scene[4200], yours[4200], reference[4200], picture[4200];
    const ScatterStage *stage = &scatter_stages[result->stage - 1];
    snprintf(program, sizeof program, "%s/photonlab", options->build);
    snprintf(scene, sizeof scene, "%s/%s", options->root, stage->scene);
    snprintf(yours, sizeof yours, "%s/scatter_%d/yours.photons", options->work, result->stage);
    snprintf(reference, sizeof reference, "%s/scatter_%d/reference.photons", options->work, result->stage);
    snprintf(picture, sizeof picture, "%s/pictures/scatter_%d.png", directory, result->stage);
    unlink(picture);
    if (!write_photons(&result->yours, yours, error) || !write_photons(&result->reference, reference, error))
        return false;
    const char *const words[] = {program,   "preview",  scene,         "--photons-file", yours,      "--reference-file",
                                 reference, "--colour", stage->colour, "--size",         "1200x600", "--snapshot",
                                 picture,   NULL};
    return run_preview(words, error);
}

void scatter_draw(const GradeOptions *options, const char *directory, StageResult *result)
{
    Error error = {""};
    if (!result->yours.numbers || !result->reference.numbers)
        return;
    if (draw(options, directory, result, &error))
        snprintf(result->picture, sizeof result->picture, "pictures/scatter_%d.png", result->stage);
    else
        snprintf(result->picture_message, sizeof result->picture_message, "%.290s", error.message);
}
