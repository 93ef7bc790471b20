/* Starts a plant and a controller with a wire between them, and waits until both have ended:
 *
 *     join PLANT [ARGUMENT...] -- CONTROLLER [ARGUMENT...]
 *
 * The last -- is the one between them. Each has an end as descriptor 3, and knows. The exit status is 0 if that of both
 * is; a plant that was not told how long to run is ended when the controller has. What a failure leaves ends with the
 * time that a test has (tests/harness/tap.py). */
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

enum { WIRE = 3, MOST_SECONDS = 1800 };

static pid_t started(char **const command, const int end)
{
    const pid_t child = fork();
    if (child == 0) {
        alarm(MOST_SECONDS);
        if (end != WIRE) {
            (void)dup2(end, WIRE);
        }
        for (int file = WIRE + 1; file < 10; file++) {
            (void)close(file);
        }
        execvp(command[0], command);
        perror(command[0]);
        _exit(127);
    }
    return child;
}

int main(int count, char **const arguments)
{
    int wire[2], middle = count - 1;
    while (middle > 1 && strcmp(arguments[middle], "--") != 0) {
        middle--;
    }
    if (middle < 2 || middle + 1 >= count || socketpair(AF_UNIX, SOCK_STREAM, 0, wire) != 0 ||
        setenv("ISOCHRON_CONTROLLER", "fd:3", 1) != 0 || setenv("ISOCHRON_LINK", "fd:3", 1) != 0) {
        fprintf(stderr, "usage: join PLANT [ARGUMENT...] -- CONTROLLER [ARGUMENT...]\n");
        return EXIT_FAILURE;
    }
    const bool is_endless = middle == 2;
    arguments[middle] = NULL;
    const pid_t plant = started(arguments + 1, wire[0]);
    const pid_t controller = started(arguments + middle + 1, wire[1]);
    (void)close(wire[0]);
    if (!is_endless) { /* such a plant ends when its controller has gone */
        (void)close(wire[1]);
    }
    int of_plant = 1, of_controller = 1;
    (void)waitpid(controller, &of_controller, 0);
    if (is_endless) {
        (void)kill(plant, SIGTERM);
    }
    (void)waitpid(plant, &of_plant, 0);
    of_plant = is_endless && WIFSIGNALED(of_plant) && WTERMSIG(of_plant) == SIGTERM ? 0 : of_plant;
    return of_plant == 0 && of_controller == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
