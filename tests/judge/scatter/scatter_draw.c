// A stage's scatter as a picture: the student's photons and the reference's, side by side. The program that draws them
// reads photons from files and runs nobody's code.
#define _GNU_SOURCE // for signals of a child
#include "judge/scatter/scatter.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#define PATIENCE 20.0 // s

static void wait_for(pid_t child, int *status)
{
    double start = clock_seconds();
    while (waitpid(child, status, WNOHANG) == 0) {
        if (clock_seconds() - start > PATIENCE) {
            kill(child, SIGKILL);
            waitpid(child, status, 0);
            return;
        }
        nanosleep(&(struct timespec){0, 5000000}, NULL);
    }
}

// The program's last words are the reason when it ends with anything but 0.
static bool run_preview(char *const *words, Error *error)
{
    int ends[2], status = 1;
    if (pipe(ends) != 0)
        return error_set(error, "no pipe: %s", strerror(errno));
    pid_t child = fork();
    if (child == 0) {
        int nothing = open("/dev/null", O_RDWR);
        dup2(nothing, 0);
        dup2(nothing, 1);
        dup2(ends[1], 2);
        close(ends[0]);
        execv(words[0], words);
        _exit(127);
    }
    close(ends[1]);
    char said[400] = "";
    if (child > 0) {
        wait_for(child, &status);
        fcntl(ends[0], F_SETFL, O_NONBLOCK);
        ssize_t got = read(ends[0], said, sizeof said - 1);
        said[got > 0 ? got : 0] = '\0';
    }
    close(ends[0]);
    if (child > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0)
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
    char *copies[sizeof words / sizeof *words];
    memcpy(copies, words, sizeof words);
    return run_preview(copies, error);
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
