// Which system calls a student's code may make. The probe computes, prints, and writes to a descriptor that is open already:
// it may make the calls in `probe_may`. Some others raise SIGSYS, and the probe's handler names the call; all others are
// unknown to it, as on an older kernel. Compilers start processes and write files; the calls that they have no business with fail.
#define _GNU_SOURCE // memfd_create
#include "judge/sandbox/sandbox_parts.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <seccomp.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <unistd.h>

// Neither steps nor compilers may call these, which reach other processes, other machines, or settings of the kernel.
static const char never[] =
    "socket socketpair ptrace process_vm_readv process_vm_writev kcmp pidfd_open pidfd_getfd "
    "pidfd_send_signal process_madvise mount umount2 pivot_root chroot setns unshare fsopen fsmount fspick "
    "fsconfig move_mount open_tree mount_setattr setuid setgid setreuid setregid setresuid setresgid "
    "setgroups setfsuid setfsgid capset add_key request_key keyctl bpf perf_event_open userfaultfd "
    "io_uring_setup io_uring_enter io_uring_register open_by_handle_at name_to_handle_at shmget shmat semget "
    "msgget mq_open mq_unlink quotactl acct swapon reboot init_module finit_module kexec_load fanotify_init "
    "syslog";

// Compilers may call these, and steps may not.
static const char probe_never[] =
    "fork vfork clone clone3 kill tkill rt_sigqueueinfo rt_tgsigqueueinfo setsid setpgid memfd_create "
    "memfd_secret execveat personality creat mkdir mkdirat mknod mknodat link linkat symlink symlinkat "
    "rename renameat renameat2 unlink unlinkat rmdir chmod fchmod fchmodat fchmodat2 chown lchown fchown "
    "fchownat truncate utime utimes utimensat setxattr lsetxattr fsetxattr";

// What the loader, the C library, the sanitizers and the probe call. prctl is not among them: fill_for_probe allows two of its
// uses, which only take rights away.
static const char probe_may[] =
    "read write readv writev pread64 pwrite64 close lseek _llseek fstat fstat64 stat stat64 lstat lstat64 fstatat64 newfstatat statx "
    "access faccessat faccessat2 readlink readlinkat getcwd getdents getdents64 fcntl fcntl64 ioctl dup dup2 dup3 poll ppoll "
    "ppoll_time64 select pselect6 brk mmap2 mprotect munmap mremap madvise msync mincore futex futex_time64 set_robust_list "
    "get_robust_list set_tid_address rseq membarrier sched_yield sched_getaffinity getcpu gettid getpid getppid getpgrp getuid "
    "geteuid getgid getegid getresuid getresgid uname sysinfo getrandom getrusage getrlimit ugetrlimit times time gettimeofday "
    "clock_gettime clock_gettime64 clock_getres clock_nanosleep clock_nanosleep_time64 nanosleep alarm setitimer getitimer pause "
    "rt_sigaction rt_sigprocmask rt_sigreturn sigreturn rt_sigpending rt_sigsuspend rt_sigtimedwait sigaltstack tgkill "
    "restart_syscall arch_prctl set_thread_area set_tls cacheflush riscv_flush_icache execve exit exit_group";

// Calls that this machine's kernel does not know have no number and need no rule.
static bool rule_for_all(scmp_filter_ctx filter, uint32_t action, const char *names)
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

#define READS (O_RDONLY | O_CLOEXEC | O_DIRECTORY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_LARGEFILE)

// Opens with READS alone; any other bit of the flags, and the call raises SIGSYS.
static bool allow_reading(scmp_filter_ctx filter, const char *name, unsigned flags)
{
    int number = seccomp_syscall_resolve_name(name);
    const struct scmp_arg_cmp reads = SCMP_CMP64(flags, SCMP_CMP_MASKED_EQ, 0xffffffffu & ~(unsigned)READS, 0);
    bool ok = number < 0 || seccomp_rule_add_array(filter, SCMP_ACT_ALLOW, number, 1, &reads) == 0;
    for (unsigned bit = 1; ok && number >= 0 && bit != 0; bit <<= 1) {
        const struct scmp_arg_cmp more = SCMP_CMP64(flags, SCMP_CMP_MASKED_EQ, bit, bit);
        ok = (bit & READS) || seccomp_rule_add_array(filter, SCMP_ACT_TRAP, number, 1, &more) == 0;
    }
    return ok;
}

static bool allow_with(scmp_filter_ctx filter, int number, uint64_t first)
{
    const struct scmp_arg_cmp is_first = SCMP_CMP64(0, SCMP_CMP_EQ, first, 0);
    return seccomp_rule_add_array(filter, SCMP_ACT_ALLOW, number, 1, &is_first) == 0;
}

static bool fill_for_probe(scmp_filter_ctx filter, long memory_mb)
{
    // A request for more memory than the limit is stopped here, where it is made; refused, it would crash the program later.
    uint64_t most = memory_mb > 0 ? (uint64_t)memory_mb << 20 : UINT64_MAX;
    const struct scmp_arg_cmp huge = SCMP_CMP64(1, SCMP_CMP_GE, most, 0), other = SCMP_CMP64(1, SCMP_CMP_LT, most, 0);
    return allow_with(filter, SCMP_SYS(prctl), PR_SET_NO_NEW_PRIVS) &&
           allow_with(filter, SCMP_SYS(prctl), PR_SET_SECCOMP) &&
           allow_with(filter, SCMP_SYS(prlimit64), 0) && // of the process itself
           rule_for_all(filter, SCMP_ACT_TRAP, never) && rule_for_all(filter, SCMP_ACT_TRAP, probe_never) &&
           rule_for_all(filter, SCMP_ACT_ALLOW, probe_may) && allow_reading(filter, "open", 1) &&
           allow_reading(filter, "openat", 2) &&
           seccomp_rule_add_array(filter, SCMP_ACT_TRAP, SCMP_SYS(mmap), 1, &huge) == 0 &&
           seccomp_rule_add_array(filter, SCMP_ACT_ALLOW, SCMP_SYS(mmap), 1, &other) == 0;
}

static bool fill_for_compiler(SandboxKind kind, scmp_filter_ctx filter)
{
    // Without a user or processes of its own, its group is what is ended with it: nobody leaves it.
    const char *leaving = kind == SANDBOX_LANDLOCK ? "setsid setpgid" : "";
    const struct scmp_arg_cmp new_user = SCMP_CMP64(0, SCMP_CMP_MASKED_EQ, CLONE_NEWUSER, CLONE_NEWUSER);
    const struct scmp_arg_cmp outlive = SCMP_CMP64(0, SCMP_CMP_EQ, PR_SET_PDEATHSIG, 0);
    return rule_for_all(filter, SCMP_ACT_ERRNO(EPERM), never) && rule_for_all(filter, SCMP_ACT_ERRNO(EPERM), leaving) &&
           seccomp_rule_add_array(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(prctl), 1, &outlive) == 0 &&
           seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3), 0) ==
               0 && // the C library then takes clone
           seccomp_rule_add_array(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(clone), 1, &new_user) == 0;
}

static int export_filter(SandboxKind kind, const SandboxRun *run, scmp_filter_ctx filter)
{
    if (!(run->compiler ? fill_for_compiler(kind, filter) : fill_for_probe(filter, run->memory_mb)))
        return -1;
    int fd = memfd_create("filter", MFD_CLOEXEC);
    if (fd >= 0 && (seccomp_export_bpf(filter, fd) != 0 || lseek(fd, 0, SEEK_SET) != 0)) {
        close(fd);
        fd = -1;
    }
    return fd;
}

static bool load(Launch *launch)
{
    struct stat state;
    if (fstat(launch->filter_fd, &state) != 0 || state.st_size <= 0)
        return false;
    launch->filter_size = (size_t)state.st_size;
    launch->filter = malloc(launch->filter_size);
    return launch->filter && pread(launch->filter_fd, launch->filter, launch->filter_size, 0) == state.st_size;
}

bool sandbox_filter(SandboxKind kind, const SandboxRun *run, Launch *launch, Error *error)
{
#pragma omp critical(sandbox_filter)
    { // the library does not say whether several threads may use it
        scmp_filter_ctx filter = seccomp_init(run->compiler ? SCMP_ACT_ALLOW : SCMP_ACT_ERRNO(ENOSYS));
        if (filter)
            launch->filter_fd = export_filter(kind, run, filter);
        if (filter)
            seccomp_release(filter);
    }
    if (launch->filter_fd < 0)
        return error_set(error, "the filter of system calls could not be made");
    return kind == SANDBOX_BUBBLEWRAP || load(launch) ||
           error_set(error, "the filter of system calls could not be read");
}

bool sandbox_filter_enter(const Launch *launch)
{
    struct sock_fprog program = {(unsigned short)(launch->filter_size / sizeof(struct sock_filter)), launch->filter};
    return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

void sandbox_end_with_parent(void)
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
}

char *sandbox_call_name(long long number)
{
    return seccomp_syscall_resolve_num_arch(SCMP_ARCH_NATIVE, (int)number);
}
