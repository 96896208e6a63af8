// Which system calls a student's code may make. The probe computes, prints, and writes to a descriptor that is open
// already: whatever it has no business with raises SIGSYS, and the probe's handler names the call. Compilers start
// processes and write files; the calls that they have no business with fail.
#define _GNU_SOURCE // memfd_create
#include "judge/sandbox/sandbox_parts.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <seccomp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <unistd.h>

// Nobody's business: other processes, other machines, the kernel's locks.
static const char never[] =
    "socket socketpair ptrace process_vm_readv process_vm_writev kcmp pidfd_open pidfd_getfd "
    "pidfd_send_signal process_madvise mount umount2 pivot_root chroot setns unshare fsopen fsmount fspick "
    "fsconfig move_mount open_tree mount_setattr setuid setgid setreuid setregid setresuid setresgid "
    "setgroups setfsuid setfsgid capset add_key request_key keyctl bpf perf_event_open userfaultfd "
    "io_uring_setup io_uring_enter io_uring_register open_by_handle_at name_to_handle_at shmget shmat semget "
    "msgget mq_open mq_unlink quotactl acct swapon reboot init_module finit_module kexec_load fanotify_init "
    "syslog";

// Compilers do these.
static const char probe_never[] =
    "fork vfork clone clone3 kill tkill rt_sigqueueinfo rt_tgsigqueueinfo setsid setpgid memfd_create "
    "memfd_secret execveat personality creat mkdir mkdirat mknod mknodat link linkat symlink symlinkat "
    "rename renameat renameat2 unlink unlinkat rmdir chmod fchmod fchmodat fchmodat2 chown lchown fchown "
    "fchownat truncate utime utimes utimensat setxattr lsetxattr fsetxattr";

// Calls that this machine's kernel does not know have no number and need no rule.
static bool forbid_all(scmp_filter_ctx filter, uint32_t action, const char *names)
{
    while (*names) {
        char name[64];
        size_t length = strcspn(names, " ");
        snprintf(name, sizeof name, "%.*s", (int)length, names);
        names += length + (names[length] == ' ');
        int number = seccomp_syscall_resolve_name(name);
        if (number >= 0 && seccomp_rule_add(filter, action, number, 0) != 0)
            return false;
    }
    return true;
}

static bool forbid_writing(scmp_filter_ctx filter, const char *name, unsigned flags)
{
    int number = seccomp_syscall_resolve_name(name);
    const struct scmp_arg_cmp wants[] = {SCMP_CMP64(flags, SCMP_CMP_MASKED_EQ, O_ACCMODE, O_WRONLY),
                                         SCMP_CMP64(flags, SCMP_CMP_MASKED_EQ, O_ACCMODE, O_RDWR),
                                         SCMP_CMP64(flags, SCMP_CMP_MASKED_EQ, O_CREAT, O_CREAT)};
    for (size_t i = 0; number >= 0 && i < sizeof wants / sizeof *wants; i++)
        if (seccomp_rule_add_array(filter, SCMP_ACT_TRAP, number, 1, &wants[i]) != 0)
            return false;
    return true;
}

static bool fill_for_probe(scmp_filter_ctx filter, long memory_mb)
{
    bool ok = forbid_all(filter, SCMP_ACT_TRAP, never) && forbid_all(filter, SCMP_ACT_TRAP, probe_never);
    ok = ok && forbid_writing(filter, "open", 1) && forbid_writing(filter, "openat", 2);
    // Its flags are behind a pointer; the C library then takes openat.
    ok = ok && seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(openat2), 0) == 0;
    // A request beyond the limit would only fail, and crash the program later, elsewhere.
    const struct scmp_arg_cmp huge = SCMP_CMP64(1, SCMP_CMP_GE, (uint64_t)memory_mb << 20, 0);
    if (ok && memory_mb > 0)
        ok = seccomp_rule_add_array(filter, SCMP_ACT_TRAP, SCMP_SYS(mmap), 1, &huge) == 0;
    return ok;
}

static bool fill_for_compiler(scmp_filter_ctx filter)
{
    const struct scmp_arg_cmp new_user = SCMP_CMP64(0, SCMP_CMP_MASKED_EQ, CLONE_NEWUSER, CLONE_NEWUSER);
    return forbid_all(filter, SCMP_ACT_ERRNO(EPERM), never) &&
           seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3), 0) ==
               0 && // the C library then takes clone
           seccomp_rule_add_array(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(clone), 1, &new_user) == 0;
}

static int export_filter(const SandboxRun *run, scmp_filter_ctx filter)
{
    if (!(run->compiler ? fill_for_compiler(filter) : fill_for_probe(filter, run->memory_mb)))
        return -1;
    int fd = memfd_create("filter", MFD_CLOEXEC);
    if (fd >= 0 && (seccomp_export_bpf(filter, fd) != 0 || lseek(fd, 0, SEEK_SET) != 0)) {
        close(fd);
        fd = -1;
    }
    return fd;
}

int sandbox_filter(const SandboxRun *run, Error *error)
{
    int fd = -1;
#pragma omp critical(sandbox_filter)
    { // the library does not say whether several threads may use it
        scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
        if (filter)
            fd = export_filter(run, filter);
        if (filter)
            seccomp_release(filter);
    }
    if (fd < 0)
        error_set(error, "the filter of system calls could not be made");
    return fd;
}

bool sandbox_filter_read(Launch *launch, Error *error)
{
    struct stat state;
    if (fstat(launch->filter_fd, &state) != 0 || state.st_size <= 0)
        return error_set(error, "the filter of system calls could not be read");
    launch->filter_size = (size_t)state.st_size;
    launch->filter = malloc(launch->filter_size);
    if (!launch->filter || pread(launch->filter_fd, launch->filter, launch->filter_size, 0) != state.st_size)
        return error_set(error, "the filter of system calls could not be read");
    return true;
}

bool sandbox_filter_enter(const Launch *launch)
{
    struct sock_fprog program = {(unsigned short)(launch->filter_size / sizeof(struct sock_filter)), launch->filter};
    return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}
