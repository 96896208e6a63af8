// class_unpack: finds a student's steps in whatever was handed in.
//
//   archive or directory ──▶ archive.c / directory.c ──▶ Found: C files in memory ──▶ choose.c ──▶ TO/<stage>/<step>.c
//
// Nothing that an archive says about paths, links, owners or rights ever reaches the disk: only names from the step
// table and plain header names are written.
#ifndef PHOTONLAB_CLASS_UNPACK_H
#define PHOTONLAB_CLASS_UNPACK_H

#include "error.h"

#include <stdbool.h>
#include <stddef.h>

#define MOST_ENTRIES   20000u       // files and folders
#define MOST_UNPACKED  (256u << 20) // bytes, all of an archive
#define MOST_FILE      (1u << 20)   // bytes of one C file; the judge takes no more
#define MOST_KEPT      (32u << 20)  // bytes of all C files
#define MOST_DEPTH     12           // folders in folders
#define UNPACK_SECONDS 20           // of processor time

typedef struct {
    char *path; // below the submission's top
    char *bytes;
    size_t size;
    bool broken; // a link, or too large: known by its name alone
} FoundFile;

typedef struct {
    FoundFile *files; // *.c and *.h
    size_t count, kept, entries;
    char archive[1024]; // in a directory: the only archive in it; "" none
    size_t archives;
} Found;

// Is it a file that may be wanted? Hidden files, macOS's second copies and paths with `..` are not.
bool found_wants(const char *path);
bool found_is_archive(const char *name);

// Takes over the bytes (NULL for a broken file). False when the bounds above are passed.
bool found_add(Found *found, const char *path, char *bytes, size_t size, Error *error);
bool found_count(Found *found, Error *error); // one more entry
void found_free(Found *found);

bool archive_find(const char *path, Found *found, Error *error);
bool directory_find(const char *path, Found *found, Error *error);

// Writes the steps and the headers beside them to `to`; how many steps, −1 on error. `note` gets what was left out.
int choose_and_write(const Found *found, const char *to, char *note, size_t size, Error *error);

#endif
