// The C files of an archive, read in one pass into memory.
#include "class/unpack/unpack.h"

#include <archive.h>
#include <archive_entry.h>
#include <stdlib.h>
#include <string.h>

static struct archive *open_archive(const char *path, Error *error)
{
    struct archive *archive = archive_read_new();
    if (!archive)
        return error_set(error, "no memory to read it"), NULL;
    archive_read_support_filter_gzip(archive);
    archive_read_support_filter_xz(archive);
    archive_read_support_filter_bzip2(archive);
    archive_read_support_format_tar(archive);
    archive_read_support_format_zip(archive);
    if (archive_read_open_filename(archive, path, 1 << 16) != ARCHIVE_OK) {
        error_set(error, "it is no archive that can be read (.tar.gz, .tar.xz, .zip)");
        archive_read_free(archive);
        return NULL;
    }
    return archive;
}

static bool damaged(struct archive *archive, Error *error)
{
    const char *why = archive_error_string(archive);
    return error_set(error, "the archive is damaged or locked%s%s", why ? ": " : "", why ? why : "");
}

// The whole content of one entry. False only when the archive itself is at fault.
static bool read_entry(struct archive *archive, struct archive_entry *entry, const char *path, Found *found,
                       Error *error)
{
    if (archive_entry_filetype(entry) != AE_IFREG || archive_entry_hardlink(entry))
        return found_add(found, path, NULL, 0, "is a link", error);
    char *bytes = malloc(MOST_FILE + 1);
    if (!bytes)
        return error_set(error, "no memory to read it");
    size_t size = 0;
    la_ssize_t got = 0;
    while (size <= MOST_FILE && (got = archive_read_data(archive, bytes + size, MOST_FILE + 1 - size)) > 0)
        size += (size_t)got;
    if (got < 0 || size > MOST_FILE) {
        free(bytes);
        return got < 0 ? damaged(archive, error) : found_add(found, path, NULL, 0, "is larger than 1 MB", error);
    }
    char *shorter = realloc(bytes, size + 1);
    return found_add(found, path, shorter ? shorter : bytes, size, NULL, error);
}

static const char *name_of(struct archive_entry *entry)
{
    const char *path = archive_entry_pathname(entry);
    if (!path)
        path = archive_entry_pathname_utf8(entry);
    while (path && strncmp(path, "./", 2) == 0)
        path += 2;
    return path ? path : "";
}

bool archive_find(const char *path, Found *found, Error *error)
{
    struct archive *archive = open_archive(path, error);
    if (!archive)
        return false;
    struct archive_entry *entry;
    bool ok = true;
    int code;
    la_int64_t bytes = 0;
    while (ok && (code = archive_read_next_header(archive, &entry)) != ARCHIVE_EOF) {
        if (code < ARCHIVE_WARN) {
            ok = damaged(archive, error);
            break;
        }
        ok = found_count(found, error);
        bytes += archive_entry_size(entry); // before any of it is unpacked
        if (ok && (bytes > (la_int64_t)MOST_UNPACKED || archive_filter_bytes(archive, 0) > (la_int64_t)MOST_UNPACKED))
            ok = error_set(error, "it unpacks to more than %u MB", MOST_UNPACKED >> 20);
        if (ok && found_wants(name_of(entry)) && archive_entry_filetype(entry) != AE_IFDIR)
            ok = read_entry(archive, entry, name_of(entry), found, error);
    }
    if (ok && found->entries == 0)
        ok = error_set(error, "the archive is empty");
    archive_read_free(archive);
    return ok;
}
