#define _GNU_SOURCE // MAP_ANONYMOUS
#include "preview/run/broker.h"
#include "base/parallel.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#ifndef MSG_NOSIGNAL
#define MSG_NOSIGNAL 0
#endif

static WireHeart *share_hearts(void)
{
    void *memory =
        mmap(NULL, MOST_HEARTS * sizeof(WireHeart), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    return memory == MAP_FAILED ? NULL : memory;
}

static bool fork_helper(Broker *broker, const Scene *scene, Error *error)
{
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0)
        return error_set(error, "preview: no socket for the helper process: %s", strerror(errno));
    for (int i = 0; i < 2; i++)
        fcntl(ends[i], F_SETFD, FD_CLOEXEC);
    fflush(NULL); // or the helper would print it again
    broker->pid = fork();
    if (broker->pid == 0) {
        close(ends[0]);
        helper_run(scene, ends[1], broker->hearts);
    }
    close(ends[1]);
    if (broker->pid < 0) {
        close(ends[0]);
        return error_set(error, "preview: cannot start a helper process: %s", strerror(errno));
    }
    broker->socket = ends[0];
    fcntl(broker->socket, F_SETFL, O_NONBLOCK);
    return true;
}

Broker *broker_start(const Scene *scene, const char *code_source, Error *error)
{
    Broker *broker = calloc(1, sizeof *broker);
    WireHeart *hearts = share_hearts();
    if (broker && hearts) {
        broker->hearts = hearts;
        broker_workers(broker, 0);
        snprintf(broker->code_source, sizeof broker->code_source, "%s", code_source ? code_source : "");
        if (fork_helper(broker, scene, error))
            return broker;
    } else {
        error_set(error, "preview: not enough memory for the helper process");
    }
    if (hearts)
        munmap(hearts, MOST_HEARTS * sizeof *hearts);
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
    while (waitpid(broker->pid, NULL, 0) < 0 && errno == EINTR) {
    }
    munmap(broker->hearts, MOST_HEARTS * sizeof *broker->hearts);
    free(broker);
}

static void lose_helper(Broker *broker)
{
    close(broker->socket);
    broker->socket = -1;
}

// Waits until there is space: the helper always listens.
static bool send_rest(Broker *broker, const char *rest, size_t size)
{
    while (size > 0) {
        ssize_t sent = send(broker->socket, rest, size, MSG_NOSIGNAL);
        if (sent > 0) {
            rest += sent;
            size -= (size_t)sent;
        } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
            usleep(200);
        } else if (errno != EINTR) {
            return false;
        }
    }
    return true;
}

// Descriptors travel with the first byte.
static ssize_t send_with_pipes(Broker *broker, const WireOrder *order, const int *pipes)
{
    union {
        struct cmsghdr head;
        char bytes[CMSG_SPACE(MOST_WORKERS * sizeof(int))];
    } control;
    size_t size = (size_t)order->workers * sizeof(int);
    struct iovec part = {(void *)order, sizeof *order};
    struct msghdr message;
    memset(&control, 0, sizeof control);
    memset(&message, 0, sizeof message);
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    message.msg_control = &control;
    message.msg_controllen = CMSG_SPACE(size);
    control.head.cmsg_level = SOL_SOCKET;
    control.head.cmsg_type = SCM_RIGHTS;
    control.head.cmsg_len = CMSG_LEN(size);
    memcpy(CMSG_DATA(&control.head), pipes, size);
    for (;;) {
        ssize_t sent = sendmsg(broker->socket, &message, MSG_NOSIGNAL);
        if (sent > 0 || (errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR))
            return sent;
        usleep(200);
    }
}

bool broker_send(Broker *broker, const WireOrder *order, const int *pipes)
{
    if (broker->socket < 0)
        return false;
    ssize_t sent = order->kind == ORDER_START ? send_with_pipes(broker, order, pipes) : 0;
    if (sent >= 0 && send_rest(broker, (const char *)order + sent, sizeof *order - (size_t)sent))
        return true;
    lose_helper(broker);
    return false;
}

static void pass_on(Broker *broker, const WireEnd *end)
{
    for (int i = 0; i < MOST_HEARTS; i++)
        if (broker->uses[i].run == end->run && broker->uses[i].worker == end->worker)
            broker->uses[i] = (HeartUse){0, 0};
    Run *run = run_find(broker, end->run);
    if (run)
        run_note_end(run, end->worker, end->status);
}

void broker_listen(Broker *broker)
{
    while (broker->socket >= 0) {
        ssize_t size = recv(broker->socket, broker->incoming + broker->incoming_size,
                            sizeof broker->incoming - broker->incoming_size, 0);
        if (size < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR))
            return;
        if (size <= 0) {
            lose_helper(broker);
            return;
        }
        broker->incoming_size += (size_t)size;
        if (broker->incoming_size < sizeof(WireEnd))
            continue;
        WireEnd end;
        memcpy(&end, broker->incoming, sizeof end);
        broker->incoming_size = 0;
        pass_on(broker, &end);
    }
}
