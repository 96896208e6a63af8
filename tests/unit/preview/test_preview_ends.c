// Helper and workers end when they should, and leave nothing behind.
#include "unit/preview/preview_helpers.h"

#include <dirent.h>
#include <signal.h>
#include <sys/wait.h>

static const Fault endless = {"endless", LOOP, IN_LOOP("for (volatile int i = 0;; i++) {}")};

static int count_files(void)
{
    int count = 0;
    DIR *directory = opendir("/proc/self/fd");
    while (directory && readdir(directory))
        count++;
    if (directory)
        closedir(directory);
    return count;
}

// Processes that the helper has, dead ones included; −1 where the system does not tell.
static int count_workers(void)
{
    char path[128], text[4096] = "";
    snprintf(path, sizeof path, "/proc/%ld/task/%ld/children", (long)broker->pid, (long)broker->pid);
    FILE *file = fopen(path, "r");
    if (!file)
        return -1;
    int count = 0;
    if (fgets(text, sizeof text, file))
        for (char *word = strtok(text, " "); word; word = strtok(NULL, " "))
            count++;
    fclose(file);
    return count;
}

TEST(nothing_is_left_of_200_runs)
{
    int before = count_files();
    for (int i = 0; i < 200; i++) {
        RunRequest request = photons_request(i % 5 ? "endless" : NULL);
        Run *run = start(&request);
        if (i % 2)
            run_wait(run, 0.001);
        run_poll(run);
        run_free(run);
    }
    assert_int_equal(count_files(), before);
    for (double until = clock_seconds() + 5.0; count_workers() > 0 && clock_seconds() < until;)
        usleep(1000);
    assert_true(count_workers() <= 0);
    assert_int_equal(waitpid(-1, NULL, WNOHANG), 0); // the helper lives, nobody else is there
    good_run("after 200 runs");
}

// Dead, if not yet buried: whose task that is differs.
static bool is_zombie(long pid)
{
    char path[64], text[512] = "";
    snprintf(path, sizeof path, "/proc/%ld/stat", pid);
    FILE *file = fopen(path, "r");
    bool zombie = file && fgets(text, sizeof text, file) && strstr(text, ") Z");
    if (file)
        fclose(file);
    return zombie;
}

static bool is_gone(long pid)
{
    for (double until = clock_seconds() + 5.0; clock_seconds() < until; usleep(1000))
        if (kill((pid_t)pid, 0) != 0 || is_zombie(pid))
            return true;
    return false;
}

// A window that is killed takes helper and workers with it.
TEST(the_helper_ends_with_the_window)
{
    int told[2];
    assert_int_equal(pipe(told), 0);
    pid_t window = fork();
    if (window == 0) {
        Broker *own = broker_start(scene, NULL, NULL);
        RunRequest request = photons_request("endless");
        Run *run = own ? run_start(own, &request, NULL) : NULL;
        long pids[2] = {own ? (long)own->pid : 0, 0};
        for (; run && !(pids[1] = run->parts[0].pid); run_poll(run))
            usleep(1000);
        if (write(told[1], pids, sizeof pids) == (ssize_t)sizeof pids)
            pause();
        _exit(1);
    }
    long pids[2] = {0, 0};
    assert_int_equal(read(told[0], pids, sizeof pids), sizeof pids);
    assert_true(pids[0] > 0 && pids[1] > 0);
    kill(window, SIGKILL);
    waitpid(window, NULL, 0);
    assert_true(is_gone(pids[1]));
    close(told[0]);
    close(told[1]);
}

static Broker *own_broker(void)
{
    Broker *own = broker_start(scene, NULL, &said);
    assert_non_null(own);
    broker_workers(own, 2);
    return own;
}

// Another helper plays, although this process has had threads meanwhile.
static void goes_on(Broker *own)
{
    Broker *usual = broker;
    for (double until = clock_seconds() + 5.0; !broker_renew(own); usleep(10000))
        assert_true(clock_seconds() < until);
    assert_false(broker_renew(own));
    broker = own;
    good_run("by another helper");
    broker = usual;
    broker_stop(own);
}

TEST(a_lost_helper_is_replaced)
{
    Broker *own = own_broker();
    RunRequest request = photons_request("endless");
    Run *run = run_start(own, &request, &said);
    kill(own->pid, SIGKILL);
    RunStatus status = finish(run);
    assert_int_equal(status.state, RUN_FAILED);
    assert_string_equal(status.failure, "the preview's helper process was ended, or did not answer");
    assert_refused(run_start(own, &request, &said), "the preview's helper process is gone");
    goes_on(own);
}

// One that is lost while nobody asks for anything is missed, too.
TEST(a_helper_lost_in_silence_is_replaced)
{
    Broker *own = own_broker();
    kill(own->pid, SIGKILL);
    goes_on(own);
}

TEST(a_stopped_helper_is_no_endless_loop)
{
    Broker *own = own_broker();
    RunRequest request = photons_request("good");
    kill(own->pid, SIGSTOP);
    Run *run = run_start(own, &request, NULL);
    run_patience(run, 0.1);
    RunStatus status = finish(run);
    assert_int_equal(status.state, RUN_FAILED);
    assert_string_equal(status.failure, "the preview's helper process was ended, or did not answer");
    goes_on(own);
}

// So few photons are one worker's.
static Run *run_with_worker(void)
{
    RunRequest request = photons_request("endless");
    request.photons = 1000;
    Run *run = start(&request);
    while (!run->parts[0].pid) {
        run_poll(run);
        usleep(1000);
    }
    return run;
}

TEST(a_stopped_worker_is_no_endless_loop)
{
    Run *run = run_with_worker();
    kill(run->parts[0].pid, SIGSTOP);
    run_patience(run, 0.4);
    RunStatus status = finish(run);
    assert_string_equal(status.failure,
                        "a process of the run stands still and does not answer: was it stopped (kill -STOP)?");
    run_free(run);
}

// A window that was stopped itself, or a clock that jumped, is no sign against its workers.
TEST(a_pause_is_nobody_s_fault)
{
    Run *run = run_with_worker();
    run_patience(run, 0.3);
    usleep(1500000);
    run_poll(run);
    assert_true(run->parts[0].asked == 0.0);
    run_free(run);
}

AROUND_RUNS(&endless, 1)
