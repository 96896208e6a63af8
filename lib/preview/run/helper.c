// The helper process: holds the scene, forks workers, and tells when they have ended.
#define _GNU_SOURCE
#include "preview/run/run_internal.h"
#include "preview/run/worker.h"
#include "base/array.h"
#include "base/parallel.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/select.h>
#include <sys/wait.h>
#include <unistd.h>

#if defined(__linux__)
#include <sys/prctl.h>
#endif

// What students' code prints goes through the helper process: the first lines of every run, and how many more there
// were. A printf in a step of the photon's life runs a million times, and a terminal full of it hides what was wanted.
#define OUTPUT_LINES 100 // of a run, that are passed on
#define OUTPUT_BYTES 16384

typedef struct {
    int ends[2]; // of a pipe
    long lines;
    size_t bytes;    // passed on since output_end
    long more_lines; // kept back
    unsigned long more_bytes;
    bool in_line; // the last byte that was passed on ended no line
} HelperOutput;

// A worker's side: standard output and standard error go into the pipe from now on.
static void output_join(const HelperOutput *output)
{
    dup2(output->ends[1], STDOUT_FILENO);
    dup2(output->ends[1], STDERR_FILENO);
    close(output->ends[0]);
    close(output->ends[1]);
}

// The first lines are shown, the rest is counted.
static void sort(HelperOutput *output, const char *bytes, size_t size)
{
    size_t shown = 0;
    for (; shown < size && output->lines < OUTPUT_LINES && output->bytes < OUTPUT_BYTES; output->bytes++)
        output->lines += bytes[shown++] == '\n';
    write_all(STDOUT_FILENO, bytes, shown);
    if (shown > 0)
        output->in_line = bytes[shown - 1] != '\n';
    output->more_bytes += size - shown;
    for (size_t i = shown; i < size; i++)
        output->more_lines += bytes[i] == '\n';
}

// Takes what has come, without waiting.
static void output_pass_on(HelperOutput *output)
{
    char bytes[1 << 16];
    for (ssize_t got; (got = read(output->ends[0], bytes, sizeof bytes)) != 0;) {
        if (got > 0)
            sort(output, bytes, (size_t)got);
        else if (errno != EINTR)
            return; // nothing more at present
    }
}

// Takes the rest, says how much was kept back, and counts anew.
static void output_end(HelperOutput *output)
{
    char text[160] = "";
    output_pass_on(output);
    if (output->more_bytes > 0)
        snprintf(text, sizeof text,
                 "%s… and %ld more lines that your code printed; `make render CODE=exercises` shows all\n",
                 output->in_line ? "\n" : "", output->more_lines);
    else if (output->in_line)
        snprintf(text, sizeof text, "\n");
    write_all(STDOUT_FILENO, text, strlen(text));
    *output = (HelperOutput){.ends = {output->ends[0], output->ends[1]}};
}

typedef struct {
    pid_t pid;
    uint32_t run;
    int worker;
} Child;

typedef struct {
    const Scene *scene;
    int socket;
    pid_t pid; // its own
    Child *children;
    size_t count, capacity;
    HelperOutput output;
} Helper;

static void on_child(int number)
{
    (void)number; // it only has to end pselect
}

static void end(Helper *helper)
{
    for (size_t i = 0; i < helper->count; i++)
        kill(helper->children[i].pid, SIGKILL);
    output_end(&helper->output);
    _exit(0);
}

static void become_worker(const Helper *helper, const WireOrder *order, const int *pipes, int index)
{
#if defined(__linux__)
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != helper->pid) // it was gone before that
        _exit(1);
#endif
    signal(SIGCHLD, SIG_DFL);
    signal(SIGINT, SIG_DFL);
    signal(SIGPIPE, SIG_DFL);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, NULL);
    close(helper->socket);
    output_join(&helper->output);
    for (int i = 0; i < order->workers; i++)
        if (i != index)
            close(pipes[i]);
    worker_run(&(Worker){.scene = helper->scene, .order = order, .index = index}, pipes[index]);
}

static void tell_end(Helper *helper, const Child *child, int status)
{
    WireEnd message = {child->run, child->worker, status};
    if (send(helper->socket, &message, sizeof message, MSG_NOSIGNAL) != (ssize_t)sizeof message)
        end(helper);
}

static void start(Helper *helper, const WireOrder *order, const int *pipes)
{
    if (order->code[0])
        output_end(&helper->output); // what it prints is counted anew
    for (int i = 0; i < order->workers; i++) {
        bool room = array_reserve(&helper->children, helper->count + 1, &helper->capacity, sizeof(Child));
        Child child = {room ? fork() : -1, order->run, i};
        if (child.pid == 0)
            become_worker(helper, order, pipes, i);
        if (child.pid > 0)
            helper->children[helper->count++] = child;
        else
            tell_end(helper, &child, 127 << 8);
    }
    for (int i = 0; i < order->workers; i++)
        close(pipes[i]); // the end of a worker must be the end of its pipe
}

// A whole order with what came along. False: the window is gone.
static bool receive(const Helper *helper, WireOrder *order, int *pipes)
{
    WirePipes control;
    struct iovec part = {order, sizeof *order};
    struct msghdr message = {
        .msg_iov = &part, .msg_iovlen = 1, .msg_control = &control, .msg_controllen = sizeof control};
    if (recvmsg(helper->socket, &message, MSG_WAITALL) != (ssize_t)sizeof *order)
        return false;
    for (struct cmsghdr *head = CMSG_FIRSTHDR(&message); head; head = CMSG_NXTHDR(&message, head))
        if (head->cmsg_level == SOL_SOCKET && head->cmsg_type == SCM_RIGHTS)
            memcpy(pipes, CMSG_DATA(head), (size_t)order->workers * sizeof(int));
    return true;
}

static void obey(Helper *helper, const WireOrder *order, const int *pipes)
{
    if (order->signal == 0)
        start(helper, order, pipes);
    for (size_t i = 0; i < helper->count && order->signal != 0; i++) {
        const Child *child = &helper->children[i];
        if (child->run == order->run && (order->signal == SIGKILL || child->worker == order->worker))
            kill(child->pid, order->signal);
    }
}

static void reap(Helper *helper)
{
    int status;
    for (pid_t pid; (pid = waitpid(-1, &status, WNOHANG)) > 0;)
        for (size_t i = 0; i < helper->count; i++)
            if (helper->children[i].pid == pid) {
                Child child = helper->children[i];
                helper->children[i] = helper->children[--helper->count];
                if (helper->count == 0)
                    output_end(&helper->output); // before the window tells of a crash
                tell_end(helper, &child, status);
            }
}

// Signals that wait for pselect, so that none is missed between looking and sleeping.
static void set_signals(sigset_t *while_waiting)
{
    signal(SIGCHLD, on_child);
    signal(SIGINT, SIG_IGN); // the window decides what Ctrl-C means
    signal(SIGPIPE, SIG_IGN);
    sigset_t child;
    sigemptyset(&child);
    sigaddset(&child, SIGCHLD);
    sigprocmask(SIG_BLOCK, &child, while_waiting);
    sigdelset(while_waiting, SIGCHLD);
}

void helper_run(const Scene *scene, int socket)
{
    static WireOrder order;
    Helper helper = {.scene = scene, .socket = socket, .pid = getpid()};
#if defined(__linux__)
    prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
    // Students' code that waits for a key would stop the whole.
    if (!freopen("/dev/null", "r", stdin) || !pipe_open(helper.output.ends))
        _exit(1);
    parallel_limit(1);
    sigset_t while_waiting;
    set_signals(&while_waiting);
    for (;;) {
        fd_set readable;
        FD_ZERO(&readable);
        FD_SET(socket, &readable);
        FD_SET(helper.output.ends[0], &readable);
        int highest = socket > helper.output.ends[0] ? socket : helper.output.ends[0];
        int ready = pselect(highest + 1, &readable, NULL, NULL, NULL, &while_waiting);
        output_pass_on(&helper.output);
        reap(&helper);
        int pipes[MOST_WORKERS] = {-1, -1, -1, -1, -1, -1, -1, -1};
        if (ready <= 0 || !FD_ISSET(socket, &readable))
            continue;
        if (!receive(&helper, &order, pipes))
            end(&helper);
        obey(&helper, &order, pipes);
    }
}
