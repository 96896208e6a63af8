// class_unpack: finds a student's steps in whatever was handed in.
//
//   archive or directory ──▶ archive.c / directory.c ──▶ Found: C files in memory ──▶ choose.c: which ones
//                                                     count ──▶ write.c ──▶ TO/<stage>/<step>.c
//
// Beside its steps a submission may hold files to include, of the student's own: C files and headers (.c, .h, .inl), in the
// stages' folders, beside them or in folders of their own. make test, make submit and this take the same.
//
// Nothing that an archive says about links, owners or rights ever reaches the disk, and of paths only such as lead down.
#pragma once

#include "base/error.h"
#include "steps/steps.h"

#include <stdbool.h>
#include <stddef.h>

#define MOST_ENTRIES   20000u       // files and folders
#define MOST_UNPACKED  (256u << 20) // bytes, all of an archive
#define MOST_FILE      (1u << 20)   // bytes of one C file; the judge takes no more
#define MOST_KEPT      (32u << 20)  // bytes of all C files
#define MOST_DEPTH     12           // folders in folders
#define UNPACK_SECONDS 20           // of processor time
#define NOTE_SIZE      6000

typedef struct {
    char *path; // below the submission's top
    char *bytes;
    size_t size;
    const char *broken; // "is a link", …: known by its name alone; NULL: its bytes are here
} FoundFile;

typedef struct {
    FoundFile *files; // C files, whatever their endings, and links
    size_t count, kept, entries;
    char archive[1024]; // in a directory: the only archive in it; "" none
    size_t archives;
} Found;

// Is it a file that may be wanted, or should be named when it is not? Hidden files, macOS's second copies and paths with
// `..` are neither.
bool found_wants(const char *path);
bool found_is_archive(const char *name);

// Takes over the bytes; of what is broken there are none. False when the bounds above are passed.
bool found_add(Found *found, const char *path, char *bytes, size_t size, const char *broken, Error *error);
bool found_count(Found *found, Error *error); // one more entry

bool archive_find(const char *path, Found *found, Error *error);
bool directory_find(const char *path, Found *found, Error *error);

// Where a file lies: ROOT/<stage's folder>/name, or ROOT/name.
typedef struct {
    int folder, root;  // length of the path of its folder, and of ROOT
    const char *stage; // its folder's name, in step_table; NULL: loose
    int stage_length;
    const StepInfo *step; // NULL: a header, say
    const char *name;
    bool foreign; // in the framework's own folders: solutions/, tests/, …
} Place;

Place place_of(const char *path);

// Which file counts for each step.
typedef struct {
    const FoundFile *of[STEP_COUNT]; // NULL: none
    bool started[STEP_COUNT];        // it does not call todo
    bool foreign_too;                // there was nothing but foreign files
} Chosen;

bool same_words(const FoundFile *a, const FoundFile *b); // the same but for white space?

// How many steps; −1: nothing to grade; −2: cannot tell which of two files counts.
int choose_steps(const Found *found, Chosen *chosen, Error *error);
// What was not taken, and why, in at most `size` bytes.
void choose_note(const Found *found, const Chosen *chosen, char *note, size_t size);
// A file to include, below the folder that a chosen step's stage lies in: its path from there. NULL: it is none.
const char *helper_path(const FoundFile *file, const Chosen *chosen);
// Writes the steps and the files to include to `to`, with choose_steps' codes.
int write_chosen(const Found *found, const Chosen *chosen, const char *to, Error *error);
