#include "judge/scatter/scatter.h"
#include "base/text.h"

#include "judge/probe/probe_sizes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#define LEVEL 1e-3 // the chance that right code fails in the first round, as for a step

const ScatterStage scatter_stages[STAGE_COUNT] = {
    [0] = {"tests/steps/scenes/scatter_1.yaml", 24000, 16, "power"},
    [1] = {"tests/steps/scenes/scatter_2.yaml", 16000, 16, "power"},
    [2] = {"tests/steps/scenes/scatter_3.yaml", 12000, 16, "photon"},
};

// Who plays what, and where; the student's steps by their place in the table.
typedef struct {
    const GradeOptions *options;
    const ScatterStage *stage;
    ProbeJob job;   // of the student's; its directory is "" while nothing is written
    char list[100]; // "2.1,2.4"
    char play[40];  // "2.4,3.4"
} Stage;

static void list_cast(Stage *s)
{
    ProbeJob *job = &s->job;
    s->list[0] = '\0';
    memset(job->hidden, 0, sizeof job->hidden);
    for (size_t i = 0; i < STEP_COUNT; i++) {
        if (!job->student[i])
            continue;
        text_append(s->list, sizeof s->list, "%s%s", *s->list ? "," : "", step_table[i].id);
        job->hidden[i] = true;
        for (size_t j = 0; j < STEP_COUNT; j++) // solutions that do the same work are hidden, too
            job->hidden[j] = job->hidden[j] || steps_are_paired(&step_table[i], &step_table[j]);
    }
}

// The student's steps of this stage that run and play in a photon pass; of two that do the same work, the one that plays.
static void choose_cast(int stage, const StepResult *graded, int count, Stage *s)
{
    bool *student = s->job.student;
    for (int i = 0; i < count; i++)
        if (graded[i].step->stage == stage && graded[i].playable && !graded[i].hidden)
            student[graded[i].step - step_table] = graded[i].step->pass == PHOTON_PASS;
    StepChoice choice = step_choice_for(student);
    step_choice_print(choice, s->play, sizeof s->play);
    for (size_t i = 0; i < STEP_COUNT; i++)
        student[i] = student[i] && step_is_played(&step_table[i], choice);
    list_cast(s);
}

static uint64_t seed_of(const GradeOptions *options, int stage, int round, bool reference)
{
    uint64_t hash = hash_u64((uint64_t)(stage * 4 + round * 2 + reference));
    return hash_u64(hash_text(hash, options->salt) ^ 0x73636174u);
}

// Whatever the steps do, the library stores photons like this. False: the numbers are none that the probe writes.
static bool take_photons(float *numbers, long emitted, ScatterPhotons *photons)
{
    *photons =
        (ScatterPhotons){.numbers = numbers, .items = (const PhotonNumbers *)(const void *)(numbers + SCATTER_HEAD)};
    memcpy(&photons->head, numbers, sizeof photons->head);
    const PhotonNumbersHead *head = &photons->head;
    if (!photon_number_is_whole(head->stored, 1e12) || !photon_number_is_whole(head->unsound, 1e12) ||
        head->emitted != (float)emitted)
        return false;
    photons->count = head->stored < (float)SCATTER_MOST ? (long)head->stored : SCATTER_MOST;
    float path = 0.0f;
    for (long i = 0; i < photons->count; i++) {
        const PhotonNumbers *p = &photons->items[i];
        if (!photon_numbers_are_sound(p, SCATTER_MOST_MATERIALS) ||
            !photon_number_is_whole(p->emission, (double)emitted) || p->emission < path)
            return false;
        path = p->emission;
    }
    return true;
}

// One pass; false with a status and a message when it did not get through. The caller frees the numbers either way.
static bool run(const Stage *s, bool reference, uint64_t seed, ScatterPhotons *photons, StageResult *result)
{
    const GradeOptions *o = s->options;
    char line[400], *lines[] = {line};
    snprintf(line, sizeof line, "scatter %s %ld %ld %d %s %llu", s->stage->scene, s->stage->photons, SCATTER_MOST,
             s->stage->depth, s->play, (unsigned long long)seed);
    ProbeJob job = s->job;
    job.cases = reference ? "reference.txt" : "scatter.txt";
    job.list = reference ? "" : s->list;
    for (size_t i = 0; reference && i < STEP_COUNT; i++)
        job.student[i] = job.hidden[i] = false;
    Numbers numbers = {NULL, 0};
    ProbeRun ran;
    StepWords told;
    result->status = probe_job_run(o, &job, lines, 1, &numbers, &ran);
    if (result->status == STATUS_SKIP || ran.forged)
        snprintf(result->message, sizeof result->message, "%.1000s", ran.message);
    else if (result->status == STATUS_ERROR) {
        crash_describe(o, &ran.sandbox, NULL, &told);
        snprintf(result->message, sizeof result->message, "%s did not get through: %.800s",
                 reference ? "the reference" : result->steps, told.message);
    }
    if (reference && result->status == STATUS_ERROR)
        result->status = STATUS_SKIP; // no fault of the student
    photons->numbers = ran.storage;
    if (result->status != STATUS_PASS)
        return false;
    if (take_photons(photons->numbers, s->stage->photons, photons))
        return true;
    result->status = STATUS_ERROR;
    snprintf(result->message, sizeof result->message, "something other than the probe wrote to the results");
    return false;
}

// One round: both runs and what their numbers say. The photons are kept in the result.
static void play_round(const Stage *s, int round, StageResult *result)
{
    char path[4200];
    Error ignored = {""};
    if (!run(s, false, seed_of(s->options, result->stage, round, false), &result->yours, result) ||
        !run(s, true, seed_of(s->options, result->stage, round, true), &result->reference, result)) {
        stage_result_free(result);
        return;
    }
    snprintf(path, sizeof path, "%s/%s", s->options->root, s->stage->scene);
    Scene *scene = scene_load(path, &ignored);
    scatter_compare(result, scene);
    scene_free(scene);
    result->threshold = LEVEL / fmax(1.0, (double)result->tests);
    result->status = result->p < result->threshold ? STATUS_FAIL : STATUS_PASS;
    if (result->status == STATUS_PASS)
        result->message[0] = '\0';
}

// All steps are right alone: the reference takes the place of one after the other, and where that puts the photons right, the
// step is named.
static void suspect(const Stage *s, const StepResult *graded, int count, StageResult *result)
{
    char names[100] = "";
    for (int i = 0; i < count; i++)
        if (graded[i].step->stage == result->stage && graded[i].status != STATUS_PASS &&
            graded[i].status != STATUS_TODO)
            return; // that one is named already
    for (size_t i = 0; i < STEP_COUNT; i++) {
        if (!s->job.student[i])
            continue;
        Stage without = *s;
        StageResult trial = {.stage = result->stage, .p = 1.0};
        without.job.student[i] = false;
        list_cast(&without);
        play_round(&without, 0, &trial);
        if (trial.status == STATUS_PASS)
            text_append(names, sizeof names, "%s%s", *names ? " or " : "", step_table[i].id);
        stage_result_free(&trial);
    }
    text_append(result->message, sizeof result->message, ". Each of these steps passes alone");
    if (*names)
        text_append(result->message, sizeof result->message,
                    "; look at %s: with the reference in its place the photons are right", names);
    else
        text_append(result->message, sizeof result->message, ", and none is to blame alone: two may not fit together");
}

void grade_scatter(const GradeOptions *options, int stage, const StepResult *graded, int count, StageResult *result)
{
    double start = clock_seconds();
    *result = (StageResult){.stage = stage, .status = STATUS_TODO, .p = 1.0};
    Stage s = {.options = options, .stage = &scatter_stages[stage - 1]};
    s.job.cpu_seconds = options->cpu_seconds / 3.0; // it takes a twentieth of a second
    choose_cast(stage, graded, count, &s);
    if (!s.stage->scene || !*s.list)
        return;
    for (const char *c = s.list; *c; c++)
        result->steps[c - s.list] = *c == ',' ? ' ' : *c;
    snprintf(s.job.directory, sizeof s.job.directory, "%s/scatter_%d", options->work, stage);
    mkdir(s.job.directory, 0755);
    play_round(&s, 0, result);
    bool by_chance = result->status == STATUS_FAIL && result->p > 0.0;
    if (by_chance && !options->first_round_only) {
        StageResult again = {.stage = stage, .p = 1.0};
        memcpy(again.steps, result->steps, sizeof again.steps);
        play_round(&s, 1, &again);
        if (again.status != STATUS_FAIL) {
            result->status = again.status;
            memcpy(result->message, again.message, sizeof result->message);
        }
        stage_result_free(&again);
    }
    if (result->status == STATUS_FAIL && !options->first_round_only)
        suspect(&s, graded, count, result);
    result->seconds = clock_seconds() - start;
}

void stage_result_free(StageResult *result)
{
    free(result->yours.numbers);
    free(result->reference.numbers);
    result->yours = result->reference = (ScatterPhotons){.numbers = NULL};
}
