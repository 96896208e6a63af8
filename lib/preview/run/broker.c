// The window's side of the helper process.
#include "preview/run/run_internal.h"
#include "base/parallel.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static bool fork_helper(Broker *broker, Error *error)
{
    int ends[2];
    broker->born = clock_seconds();
    broker->helpers++;
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0)
        return error_set(error, "preview: no socket for the helper process: %s", strerror(errno));
    for (int i = 0; i < 2; i++)
        fcntl(ends[i], F_SETFD, FD_CLOEXEC);
    fflush(NULL); // or the helper would print it again
    broker->pid = fork();
    if (broker->pid == 0) {
        close(ends[0]);
        helper_run(broker->scene, ends[1]);
    }
    close(ends[1]);
    if (broker->pid < 0) {
        close(ends[0]);
        return error_set(error, "preview: cannot start a helper process: %s", strerror(errno));
    }
    broker->socket = ends[0];
    return true;
}

Broker *broker_start(const Scene *scene, const char *code_source, Error *error)
{
    Broker *broker = calloc(1, sizeof *broker);
    if (!broker) {
        error_set(error, "preview: not enough memory for the helper process");
        return NULL;
    }
    broker_workers(broker, 0);
    broker->scene = scene;
    snprintf(broker->code_source, sizeof broker->code_source, "%s", code_source ? code_source : "");
    if (fork_helper(broker, error))
        return broker;
    free(broker);
    return NULL;
}

void broker_workers(Broker *broker, int most)
{
    int cores = most > 0 ? most : parallel_threads(0);
    broker->workers = cores < MOST_WORKERS ? cores : MOST_WORKERS;
}

void broker_stop(Broker *broker)
{
    if (!broker)
        return;
    while (broker->runs)
        run_free(broker->runs);
    if (broker->socket >= 0) {
        shutdown(broker->socket, SHUT_RDWR); // its end is the helper's, whoever else may hold it
        close(broker->socket);
    }
    while (broker->pid > 0 && waitpid(broker->pid, NULL, 0) < 0 && errno == EINTR) {
    }
    free(broker);
}

// One that is stopped ends by this signal alone.
void broker_lose(Broker *broker)
{
    kill(broker->pid, SIGKILL);
    close(broker->socket);
    broker->socket = -1;
}

bool broker_renew(Broker *broker)
{
    broker_listen(broker);
    if (broker->socket >= 0 || broker->helpers >= MOST_HELPERS || clock_seconds() - broker->born < 1.0)
        return false;
    while (broker->pid > 0 && waitpid(broker->pid, NULL, 0) < 0 && errno == EINTR) {
    }
    Error error;
    return fork_helper(broker, &error);
}

// The helper always listens. Descriptors travel with the first byte.
bool broker_send(Broker *broker, const WireOrder *order, const int *pipes)
{
    WirePipes control = {.head = {0}};
    size_t pipes_size = (size_t)order->workers * sizeof(int);
    struct iovec rest = {(void *)order, sizeof *order};
    struct msghdr message = {.msg_iov = &rest, .msg_iovlen = 1};
    if (pipes) {
        message.msg_control = &control;
        message.msg_controllen = CMSG_SPACE(pipes_size);
        control.head.cmsg_level = SOL_SOCKET;
        control.head.cmsg_type = SCM_RIGHTS;
        control.head.cmsg_len = CMSG_LEN(pipes_size);
        memcpy(CMSG_DATA(&control.head), pipes, pipes_size);
    }
    while (broker->socket >= 0 && rest.iov_len > 0) {
        ssize_t sent = sendmsg(broker->socket, &message, MSG_NOSIGNAL);
        if (sent < 0 && errno != EINTR)
            broker_lose(broker);
        if (sent <= 0)
            continue;
        message.msg_controllen = 0;
        rest = (struct iovec){(char *)rest.iov_base + sent, rest.iov_len - (size_t)sent};
    }
    return broker->socket >= 0;
}

void broker_listen(Broker *broker)
{
    WireEnd end;
    while (broker->socket >= 0) {
        ssize_t size = recv(broker->socket, &end, sizeof end, MSG_DONTWAIT);
        if (size < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR))
            return;
        if (size != (ssize_t)sizeof end) // so few bytes are never cut
            broker_lose(broker);
        for (Run *run = broker->runs; run && broker->socket >= 0; run = run->next)
            if (run->number == end.run) {
                run->parts[end.worker].ended = true;
                run->parts[end.worker].status = end.status;
            }
    }
}
