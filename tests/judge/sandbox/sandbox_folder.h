// A folder: a directory with copies of files, each at its own path below it, for one user alone.
#pragma once

#include "base/error.h"

#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

#define FOLDER_MOST_BYTES (64L << 20) // of one file

// Makes the folder (in $TMPDIR or /tmp); its path has at most `size` bytes.
bool folder_open(char *folder, size_t size, gid_t group, Error *error);

// Copies a file or a whole directory (plain files alone, links are left out) to folder/path; `writer` owns the copies, 0: root
// does, and the group may read them. Without a writer, files that anybody may read and only root may write are hard links.
bool folder_copy(const char *folder, const char *path, uid_t writer, gid_t group, Error *error);

// Copies the plain files of folder/path back to path, which no one but the judge can write to.
void folder_take_back(const char *folder, const char *path);

void folder_close(const char *folder);

// May any user read it, from the root of the file system to everything in it? True for what is not there.
bool folder_is_open(const char *path);
