#include "preview/watch/job.h"
#include "base/parallel.h"

bool job_start(Job *job, const char *command, const char *first, const char *second)
{
    const char *const arguments[] = {"/bin/sh", "-c", command, "sh", first, second, NULL};
    job->started = clock_seconds();
    job->size = 0;
    job->text[0] = '\0';
    return process_start(&job->process, arguments, PRINTS_ALL);
}

bool job_poll(Job *job, double longest, int *status)
{
    process_read(&job->process, job->text, sizeof job->text, &job->size);
    if (clock_seconds() - job->started > longest)
        *status = -1;
    else if (!process_has_ended(&job->process, status))
        return false;
    process_read(&job->process, job->text, sizeof job->text, &job->size);
    process_end(&job->process); // closes the pipe; where it took too long, ends the job as well
    return true;
}
