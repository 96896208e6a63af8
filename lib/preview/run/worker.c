#define _GNU_SOURCE // RLIMIT_…, prctl
#include "preview/run/worker.h"
#include "base/parallel.h"
#include "base/crash_report.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

#if defined(__linux__)
#include <sys/prctl.h>
#endif

#if defined(__SANITIZE_ADDRESS__)
#define SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define SANITIZED 1
#endif
#endif

static int window = -1; // the pipe to it
static volatile sig_atomic_t sending;

static void send_all(const void *bytes, size_t size)
{
    const char *rest = bytes;
    while (size > 0) {
        ssize_t written = write(window, rest, size);
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0)
            _exit(1);
        rest += written;
        size -= (size_t)written;
    }
}

void worker_send_both(WireKind kind, const void *first, size_t first_size, const void *rest, size_t rest_size)
{
    WireHead head = {(uint32_t)kind, (uint32_t)(first_size + rest_size)};
    sending = true;
    send_all(&head, sizeof head);
    send_all(first, first_size);
    send_all(rest, rest_size);
    sending = false;
}

void worker_send(WireKind kind, const void *bytes, size_t size)
{
    worker_send_both(kind, bytes, size, NULL, 0);
}

bool worker_is_sending(void)
{
    return sending;
}

static void set_limit(int what, rlim_t most)
{
    struct rlimit limit;
    if (getrlimit(what, &limit) != 0)
        return;
    limit.rlim_cur = limit.rlim_max == RLIM_INFINITY || most < limit.rlim_max ? most : limit.rlim_max;
    setrlimit(what, &limit);
}

// A render keeps its own photons; students' code has WORKER_MEMORY_GB beside them.
static void set_limits(const Worker *worker)
{
    set_limit(RLIMIT_CORE, 0);
    set_limit(RLIMIT_STACK, 8u << 20);
#if !defined(SANITIZED) // its shadow of the memory is larger than any limit
    rlim_t own = (64u << 20) + (rlim_t)crash_peak_kb() * 1024;
    if (worker->order->request.kind == RUN_RENDER)
        own += (rlim_t)worker->order->request.photons * 256;
#if defined(__linux__)
    set_limit(RLIMIT_DATA, ((rlim_t)WORKER_MEMORY_GB << 30) + own);
#else
    set_limit(RLIMIT_AS, ((rlim_t)WORKER_MEMORY_GB << 30) + own + ((rlim_t)1 << 30));
#endif
#else
    (void)worker;
#endif
}

static bool work(Worker *worker, Error *error)
{
    const WireOrder *order = worker->order;
    if (!steps_load(order->has_code ? order->code : NULL, error))
        return false;
    worker->heart->beats++;
    worker->play = order->request.play_is_given ? order->request.play : step_choice_for_student();
    steps_play(worker->play);
    switch (order->request.kind) {
    case RUN_PHOTONS:
        return worker_photons(worker, error);
    case RUN_LOBE:
        return worker_lobe(worker, error);
    case RUN_RENDER:
        return worker_render(worker, error);
    }
    return error_set(error, "no such kind of run");
}

void worker_run(Worker *worker, int pipe)
{
#if defined(__linux__)
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != worker->helper) // it was gone before that
        _exit(1);
#endif
    window = pipe;
    parallel_limit(1); // the threads of a process do not live on in a fork
    set_limits(worker);
    setvbuf(stdout, NULL, _IOLBF, BUFSIZ); // what a step prints is out before it crashes
    worker_watch(worker->order->has_code ? worker->order->code : "");
    Error error = {""};
    errno = 0;
    bool ok = work(worker, &error);
    worker_watch_end();
    if (!ok)
        worker_send(WIRE_FAILED, error.message, strlen(error.message));
    fflush(stdout);
    _exit(ok ? 0 : 1);
}
