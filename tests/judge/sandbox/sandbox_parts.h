// What the sandbox's parts share; for tests/judge/sandbox*.c alone.
#pragma once

#include "judge/sandbox/sandbox.h"

#include <sys/types.h>

// A list that owns its words and ends with NULL, as execve takes it.
typedef struct {
    char **list;
    size_t count, capacity;
    bool out_of_memory;
} Words;

void words_add(Words *words, const char *format, ...) PRINTF_LIKE(2, 3);
void words_add_each(Words *words, const char *const *each); // NULL last
void words_free(Words *words);

// Everything that the child needs between fork and exec, where nothing may be allocated any more.
typedef struct {
    Words arguments, environment;
    int filter_fd;             // bubblewrap reads the filter from here; −1: none
    int ruleset_fd;            // what Landlock lets it open; −1: anything
    void *filter;              // not bubblewrap: the filter's instructions, loaded by the child itself
    size_t filter_size;        // bytes
    uid_t uid;                 // also its group; 0: stays who it is
    int uid_lock;              // held while the uid is in use
    char folder[64];           // SANDBOX_UID: a directory with copies of what only root may read; "" if none
    Words readable;            // must be readable as this uid
    const char *const *hidden; // must not be
} Launch;

// The program's own path, looked up in the sandbox's PATH; NULL when there is none. To be freed.
char *sandbox_find_program(const char *name);
#define SANDBOX_PATH "/usr/local/bin:/usr/bin:/bin"

// Seconds, from some time on.
double sandbox_now(void);

// A program at work: since when, when to look at it again, what processor time it had had at the last look, and when one last
// looked whether that is spent.
typedef struct {
    double begin, deadline, spent, looked; // s
} Waiting;

// s of processor time for each process.
static inline double sandbox_seconds(const SandboxRun *run)
{
    return run->cpu_seconds < 1.0 ? 1.0 : run->cpu_seconds;
}

// Ends each process that has had them: by SIGXCPU, and a second later by SIGKILL. Where it cannot, the kernel does, a second later.
void sandbox_end_spent(pid_t child, const SandboxRun *run, Waiting *waiting);

// Has it waited for wall_seconds, without any processor time? Or taken ten times as long.
bool sandbox_waits_too_long(pid_t child, const SandboxRun *run, Waiting *waiting);

// What the child could not do, on its way to the parent.
typedef struct {
    char what[160], path[512];
    int reason; // errno
} Complaint;

// The child, from fork to exec: its output goes to `out`, a complaint to `complaint`, which exec closes. Never returns.
void sandbox_become(SandboxKind kind, const SandboxRun *run, const Launch *launch, int out, int complaint);

// Reads what the child prints until it has ended, or has to be ended. Takes its state.
void sandbox_watch(pid_t child, int out, const SandboxRun *run, SandboxResult *result);

// Launch's seccomp filter as instructions of the kernel's: in a file without a name and, but for bubblewrap, in memory.
bool sandbox_filter(SandboxKind kind, const SandboxRun *run, Launch *launch, Error *error);
// In the child: from here on the filter holds. False: errno.
bool sandbox_filter_enter(const Launch *launch);
// In the child: it is killed when the judge ends, however that ends, where the kernel can.
void sandbox_end_with_parent(void);

// Around each run. SIGHUP, SIGINT and SIGTERM end what is in a sandbox, and then the judge, by the last run's end; when the judge is
// killed, a process that waits for that ends them.
void sandbox_run_begins(void);
void sandbox_group_begins(void);      // in the child, before it is anything else: its group is to end with the judge
void sandbox_group_ends(pid_t group); // ends it; before its number is free for others
bool sandbox_asked_to_end(void);
void sandbox_run_ends(void);

// Arguments of bwrap around those of the run.
bool sandbox_bubblewrap(const SandboxRun *run, Launch *launch, Error *error);

// Is Landlock in this kernel? Alone it has to keep signals in as well, which it can since Linux 6.12.
bool sandbox_landlock_is_there(bool alone);
// Launch's ruleset: the system's programs, what is readable, and the folder where `writable` lies, "" where nothing is.
bool sandbox_landlock_prepare(const SandboxRun *run, Launch *launch, const char *folder, Error *error);
// In the child: from here on the rules hold. False: errno.
bool sandbox_landlock_enter(int ruleset);

// A free uid, and a folder with copies of what is visible but closed to others.
bool sandbox_uid_prepare(const SandboxRun *run, Launch *launch, Error *error);
// In the child: becomes that user. Returns NULL, or what must be done about it, with the path in question.
const char *sandbox_uid_enter(const Launch *launch, const char **path);
// Ends whatever still runs as this user, takes the written files over, clears the folder.
void sandbox_uid_finish(const SandboxRun *run, Launch *launch);
