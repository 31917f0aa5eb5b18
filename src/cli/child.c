/* Running a program as a child process. Thread-safe: several threads may each run a child. */
#define _POSIX_C_SOURCE 200809L
#include "child.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

extern char **environ;

/* Inherited variables whose names begin so are dropped. */
static const char *const dropped[] = {
        "FIXEDGL_CAPTURE", "FIXEDGL_SIZE", "FIXEDGL_FRAMES",
        "FIXEDGL_EVENTS",  "LD_PRELOAD=",  "MESA_", "FIXEDGL_EXPLAIN", "FIXEDGL_PLAN",
        "GALLIUM_",        "GALLIVM_",     "LP_",
        "DRAW_",           "LIBGL_",
};

static bool inherited(const char *variable, const char *const *set)
{
    for (size_t i = 0; i < sizeof dropped / sizeof *dropped; i++)
        if (strncmp(variable, dropped[i], strlen(dropped[i])) == 0)
            return false;
    for (; *set != NULL; set++)
        if (strncmp(variable, *set, strcspn(*set, "=") + 1) == 0)
            return false;
    return true;
}

/* What is inherited, and `set`. The strings are borrowed; the array is the caller's. */
static char **make_environment(const char *const *set)
{
    size_t room = 1, count = 0;
    for (char **variable = environ; *variable != NULL; variable++)
        room++;
    for (const char *const *variable = set; *variable != NULL; variable++)
        room++;
    char **environment = fgl_allocate(room, sizeof *environment);
    for (char **variable = environ; *variable != NULL; variable++)
        if (inherited(*variable, set))
            environment[count++] = *variable;
    for (; *set != NULL; set++)
        environment[count++] = (char *)*set;
    return environment;
}

static int spawn(const struct child *child, pid_t *pid)
{
    posix_spawn_file_actions_t actions;
    int error = posix_spawn_file_actions_init(&actions);
    if (error != 0)
        return error;
    const int create = O_WRONLY | O_CREAT | O_TRUNC;
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, child->output, create, 0666);
    if (strcmp(child->output, child->errors) == 0)
        posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    else
        posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, child->errors, create, 0666);
    char **environment = make_environment(child->set);
    error = posix_spawnp(pid, child->argv[0], &actions, NULL, child->argv, environment);
    free(environment);
    posix_spawn_file_actions_destroy(&actions);
    return error;
}

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Waits for the child's end. False if it was still running after `timeout` seconds and had to be killed. */
static bool wait_for(pid_t pid, double timeout, int *status)
{
    const double end = seconds() + timeout;
    const struct timespec nap = {.tv_nsec = 2000000};
    while (waitpid(pid, status, WNOHANG) == 0) {
        if (seconds() > end) {
            kill(pid, SIGKILL);
            while (waitpid(pid, status, 0) < 0 && errno == EINTR)
                continue;
            return false;
        }
        nanosleep(&nap, NULL);
    }
    return true;
}

bool fgl_child_run(const struct child *child, struct problem *problem)
{
    pid_t pid;
    int status = 0;
    int error = spawn(child, &pid);
    if (error != 0)
        return fgl_problem_set(problem, "cannot start %s: %s", child->argv[0], strerror(error));
    if (!wait_for(pid, child->timeout, &status))
        return fgl_problem_set(problem, "did not end within %g s and was killed", child->timeout);
    if (WIFSIGNALED(status))
        return fgl_problem_set(problem, "crashed: signal %d (%s)", WTERMSIG(status),
                               strsignal(WTERMSIG(status)));
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        return fgl_problem_set(problem, "exited with status %d", WEXITSTATUS(status));
    return true;
}
