// The server, at this machine's own address and no other, and who is connected to it.
#include "web/serve/http.h"
#include "base/file.h"
#include "base/parallel.h"

#include <arpa/inet.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

#define MOST_CONNECTIONS 256
#define MOST_FILE        (1u << 26)
#define MOST_HEADERS     16384 // bytes of a connection, headers and answers on their way
#define ASK_WITHIN       5.0   // s from the beginning of a connection, or the last answer on it, to a whole question,
#define ASK_SOON         0.5   // … when there are many
#define MANY             64
#define LONGEST_ANSWER   60.0 // s
#define LONGEST_WAIT     20.0 // s, for news
#define MOST_TOLD        10   // times, of a reason

void server_tell(Server *server, const char *what, const char *more)
{
    Error line = {""};
    int reason = 0;
    while (reason < REASONS - 1 && server->told[reason].what && strcmp(server->told[reason].what, what) != 0)
        reason++;
    server->told[reason].what = what;
    int times = ++server->told[reason].times;
    if (times > MOST_TOLD)
        return;
    error_set(&line, "refused: %s%s%.200s%s", what, more[0] ? ": " : "", more,
              times == MOST_TOLD ? "; more of this is not told" : ""); // without control characters
    puts(line.message);
}

static void log_line(void *user, const char *format, va_list arguments)
{
    char text[300];
    vsnprintf(text, sizeof text, format, arguments);
    text[strcspn(text, "\n")] = '\0';
    server_tell(user, "the server says", text);
}

// ---- connections ----

static void on_connection(void *user, struct MHD_Connection *connection, void **context,
                          enum MHD_ConnectionNotificationCode code)
{
    Server *server = user;
    if (code == MHD_CONNECTION_NOTIFY_STARTED) {
        const union MHD_ConnectionInfo *info = MHD_get_connection_info(connection, MHD_CONNECTION_INFO_CONNECTION_FD);
        Visit *visit = malloc(sizeof *visit);
        if (!visit || !info) {
            free(visit);
            return;
        }
        *visit = (Visit){server->visits, info->connect_fd, clock_seconds(), false};
        server->visits = *context = visit;
        server->visit_count++;
        return;
    }
    Visit **link = &server->visits;
    while (*link && *link != *context)
        link = &(*link)->next;
    if (!*link)
        return;
    Visit *gone = *link;
    *link = gone->next;
    server->visit_count--;
    free(gone);
}

// Whoever asks nothing, or ever so slowly, makes room.
static void end_idle(Server *server)
{
    double now = clock_seconds(), limit = server->visit_count > MANY ? ASK_SOON : ASK_WITHIN;
    int ended = 0;
    for (Visit *visit = server->visits; visit; visit = visit->next)
        if (now - visit->since > (visit->asked ? LONGEST_ANSWER : limit)) {
            shutdown(visit->socket, SHUT_RDWR);
            visit->since = now; // it is told once
            ended += limit == ASK_SOON;
        }
    if (ended > 0)
        server_tell(server, "connections that ask nothing, while there are many", "");
}

static void resume(Server *server, bool news)
{
    Waiting **link = &server->waiting;
    while (*link) {
        Waiting *waiting = *link;
        if (!news && clock_seconds() - waiting->since < LONGEST_WAIT) {
            link = &waiting->next;
            continue;
        }
        *link = waiting->next;
        MHD_resume_connection(waiting->connection);
        free(waiting);
    }
}

// ---- the beginning ----

static bool read_files(Server *server, const char *folder, Error *error)
{
    for (Name name = 0; name < NAMES; name++) {
        char path[4096];
        if (!server_file(name))
            continue;
        snprintf(path, sizeof path, "%s/%s", folder, server_file(name));
        if (!(server->bytes[name] = file_read(path, MOST_FILE, &server->sizes[name], error)))
            return false;
    }
    return true;
}

static bool start(Server *server, const TabOptions *options, Error *error)
{
    struct sockaddr_in here = {.sin_family = AF_INET, .sin_port = htons((uint16_t)options->port)};
    here.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    server->daemon =
        MHD_start_daemon(MHD_USE_AUTO | MHD_ALLOW_SUSPEND_RESUME | MHD_USE_ERROR_LOG, 0, NULL, NULL, server_answer,
                         server, MHD_OPTION_EXTERNAL_LOGGER, log_line, server, MHD_OPTION_SOCK_ADDR,
                         (struct sockaddr *)&here, MHD_OPTION_CONNECTION_LIMIT, (unsigned)MOST_CONNECTIONS,
                         MHD_OPTION_CONNECTION_MEMORY_LIMIT, (size_t)MOST_HEADERS, MHD_OPTION_NOTIFY_COMPLETED,
                         server_answered, server, MHD_OPTION_NOTIFY_CONNECTION, on_connection, server, MHD_OPTION_END);
    if (!server->daemon)
        return error_set(error, "serve: there is no port to be had at 127.0.0.1 (%d; 0: any)", options->port);
    const union MHD_DaemonInfo *info = MHD_get_daemon_info(server->daemon, MHD_DAEMON_INFO_BIND_PORT);
    return gate_make(&server->gate, info ? info->port : options->port) ||
           error_set(error, "serve: /dev/urandom cannot be read, and so there is no token");
}

Server *server_start(Tab *tab, const TabOptions *options, Error *error)
{
    Server *server = calloc(1, sizeof *server);
    if (!server) {
        error_set(error, "serve: not enough memory");
        return NULL;
    }
    server->tab = tab;
    if (read_files(server, options->page, error) && start(server, options, error))
        return server;
    server_stop(server);
    return NULL;
}

void server_stop(Server *server)
{
    if (!server)
        return;
    resume(server, true);
    if (server->daemon)
        MHD_stop_daemon(server->daemon);
    for (Name name = 0; name < NAMES; name++)
        free(server->bytes[name]);
    free(server);
}

void server_greet(const Server *server)
{
    const Gate *gate = &server->gate;
    char host[256] = "this-machine";
    gethostname(host, sizeof host - 1);
    printf("Your photons: http://127.0.0.1:%d/%s/\n", gate->port, gate->token);
    if (gate->forwarded[0])
        printf("  In Codespaces: https://%s/%s/. ctrl-c ends it.\n", gate->forwarded, gate->token);
    else
        printf("  From another machine: ssh -L %d:127.0.0.1:%d %s, then open the same address there. ctrl-c ends it.\n",
               gate->port, gate->port, host);
}

void server_run(Server *server, int milliseconds, bool news)
{
    resume(server, news);
    end_idle(server);
    MHD_run_wait(server->daemon, milliseconds);
}
