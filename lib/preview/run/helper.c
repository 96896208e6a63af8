// The helper process: holds the scene, forks workers, and tells when they have ended.
#define _GNU_SOURCE
#include "preview/run/broker.h"
#include "preview/run/helper_output.h"
#include "preview/run/worker.h"
#include "base/parallel.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <string.h>
#include <sys/select.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#if defined(__linux__)
#include <sys/prctl.h>
#endif

#ifndef MSG_NOSIGNAL
#define MSG_NOSIGNAL 0
#endif

typedef struct {
    pid_t pid; // 0: a free place
    uint32_t run;
    int worker;
} Child;

typedef struct {
    const Scene *scene;
    int socket;
    pid_t pid; // its own
    WireHeart *hearts;
    Child children[MOST_HEARTS];
    HelperOutput output;
} Helper;

static void on_child(int number)
{
    (void)number; // it only has to end pselect
}

static void kill_all(const Helper *helper)
{
    for (int i = 0; i < MOST_HEARTS; i++)
        if (helper->children[i].pid > 0)
            kill(helper->children[i].pid, SIGKILL);
}

static void end(Helper *helper)
{
    kill_all(helper);
    output_end(&helper->output);
    _exit(0);
}

static void become_worker(const Helper *helper, const WireOrder *order, const int *pipes, int index)
{
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
    Worker worker = {.scene = helper->scene,
                     .order = order,
                     .index = index,
                     .heart = &helper->hearts[order->hearts[index]],
                     .helper = helper->pid};
    worker_run(&worker, pipes[index]);
}

static void tell_end(Helper *helper, uint32_t run, int worker, int status)
{
    WireEnd message;
    memset(&message, 0, sizeof message);
    message.run = run;
    message.worker = worker;
    message.status = status;
    if (send(helper->socket, &message, sizeof message, MSG_NOSIGNAL) != (ssize_t)sizeof message)
        end(helper);
}

static void start(Helper *helper, const WireOrder *order, const int *pipes)
{
    if (order->has_code)
        output_end(&helper->output); // what it prints is counted anew
    for (int i = 0; i < order->workers; i++) {
        Child *child = helper->children;
        while (child->pid)
            child++; // there are as many places as hearts
        WireHeart *heart = &helper->hearts[order->hearts[i]];
        heart->beats = 0;
        heart->fraction = 0.0;
        heart->pid = 0;
        pid_t pid = fork();
        if (pid == 0)
            become_worker(helper, order, pipes, i);
        if (pid < 0) {
            tell_end(helper, order->run, i, 127 << 8);
            continue;
        }
        heart->pid = (long)pid;
        *child = (Child){pid, order->run, i};
    }
    for (int i = 0; i < order->workers; i++)
        close(pipes[i]); // the end of a worker must be the end of its pipe
}

// A whole order with what came along. False: the window is gone.
static bool receive(const Helper *helper, WireOrder *order, int *pipes)
{
    union { // aligned as a header must be
        struct cmsghdr head;
        char bytes[CMSG_SPACE(MOST_WORKERS * sizeof(int))];
    } control;
    struct iovec part = {order, sizeof *order};
    struct msghdr message;
    memset(&message, 0, sizeof message);
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    message.msg_control = &control;
    message.msg_controllen = sizeof control;
    ssize_t size;
    do
        size = recvmsg(helper->socket, &message, MSG_WAITALL);
    while (size < 0 && errno == EINTR);
    for (struct cmsghdr *head = CMSG_FIRSTHDR(&message); size > 0 && head; head = CMSG_NXTHDR(&message, head))
        if (head->cmsg_level == SOL_SOCKET && head->cmsg_type == SCM_RIGHTS)
            memcpy(pipes, CMSG_DATA(head), (size_t)order->workers * sizeof(int));
    while (size > 0 && size < (ssize_t)sizeof *order) { // a signal cut it
        ssize_t more = recv(helper->socket, (char *)order + size, sizeof *order - (size_t)size, 0);
        if (more > 0)
            size += more;
        else if (more == 0 || errno != EINTR)
            size = 0;
    }
    return size > 0;
}

static void obey(Helper *helper, const WireOrder *order, const int *pipes)
{
    if (order->kind == ORDER_START) {
        start(helper, order, pipes);
        return;
    }
    for (int i = 0; i < MOST_HEARTS; i++) {
        const Child *child = &helper->children[i];
        if (child->pid > 0 && child->run == order->run && (order->kind == ORDER_END || child->worker == order->worker))
            kill(child->pid, order->kind == ORDER_END ? SIGKILL : SIGUSR1);
    }
}

static bool is_idle(const Helper *helper)
{
    for (int i = 0; i < MOST_HEARTS; i++)
        if (helper->children[i].pid > 0)
            return false;
    return true;
}

static void reap(Helper *helper)
{
    int status;
    for (pid_t pid; (pid = waitpid(-1, &status, WNOHANG)) > 0;)
        for (int i = 0; i < MOST_HEARTS; i++)
            if (helper->children[i].pid == pid) {
                helper->children[i].pid = 0;
                if (is_idle(helper))
                    output_end(&helper->output); // before the window tells of a crash
                tell_end(helper, helper->children[i].run, helper->children[i].worker, status);
            }
}

// Signals that wait for pselect, so that none is missed between looking and sleeping.
static void set_signals(sigset_t *while_waiting)
{
    struct sigaction action;
    memset(&action, 0, sizeof action);
    action.sa_handler = on_child;
    sigaction(SIGCHLD, &action, NULL);
    signal(SIGINT, SIG_IGN); // the window decides what Ctrl-C means
    signal(SIGPIPE, SIG_IGN);
    sigset_t child;
    sigemptyset(&child);
    sigaddset(&child, SIGCHLD);
    sigprocmask(SIG_BLOCK, &child, while_waiting);
    sigdelset(while_waiting, SIGCHLD);
}

void helper_run(const Scene *scene, int socket, WireHeart *hearts)
{
    static Helper helper;
    static WireOrder order;
    helper.scene = scene;
    helper.socket = socket;
    helper.hearts = hearts;
    helper.pid = getpid();
#if defined(__linux__)
    prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
    int nothing = open("/dev/null", O_RDONLY); // students' code that waits for a key would stop the whole
    if (nothing >= 0) {
        dup2(nothing, STDIN_FILENO);
        close(nothing);
    }
    output_open(&helper.output);
    parallel_limit(1);
    sigset_t while_waiting;
    set_signals(&while_waiting);
    for (;;) {
        fd_set readable;
        FD_ZERO(&readable);
        FD_SET(socket, &readable);
        int highest = socket;
        if (helper.output.read >= 0) {
            FD_SET(helper.output.read, &readable);
            highest = helper.output.read > socket ? helper.output.read : socket;
        }
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
