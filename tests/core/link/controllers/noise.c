/* A bad wire: stands between a plant, descriptor 3, and a controller that it starts, and damages what passes.
 *
 *     noise SEED CONTROLLER [ARGUMENT...]
 *
 * One byte of so many has a bit turned, is left out, or has another before it. The exit status is that of the
 * controller; or 1 if nothing was damaged. */
#include <poll.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/draw.h"

enum { WIRE = 3, ONE_OF = 800 };

static uint32_t damages;

/* Hands on what has come in. Returns false at the end. */
static bool pass(const int from, const int to)
{
    uint8_t in[256], out[2 * sizeof in];
    const ssize_t count = read(from, in, sizeof in);
    size_t n = 0;
    for (ssize_t i = 0; i < count; i++) {
        const uint32_t kind = draw(ONE_OF);
        damages += kind < 3;
        if (kind == 0) {
            out[n++] = (uint8_t)(in[i] ^ 1 << draw(8));
        } else if (kind != 1) {
            out[n] = (uint8_t)draw(256);
            n += kind == 2;
            out[n++] = in[i];
        }
    }
    return count > 0 && (n == 0 || send(to, out, n, MSG_NOSIGNAL) == (ssize_t)n);
}

int main(int count, char **const arguments)
{
    int wire[2];
    if (count < 3 || socketpair(AF_UNIX, SOCK_STREAM, 0, wire) != 0) {
        fprintf(stderr, "usage: noise SEED CONTROLLER [ARGUMENT...]\n");
        return EXIT_FAILURE;
    }
    seed = (uint32_t)atol(arguments[1]);
    const pid_t controller = fork();
    if (controller == 0) {
        (void)dup2(wire[1], WIRE);
        (void)close(wire[0]);
        (void)close(wire[1]);
        execvp(arguments[2], arguments + 2);
        _exit(127);
    }
    (void)close(wire[1]);
    bool good = true;
    while (good) {
        struct pollfd both[] = {{.fd = WIRE, .events = POLLIN}, {.fd = wire[0], .events = POLLIN}};
        good = poll(both, 2, -1) > 0;
        good = good && (both[0].revents == 0 || pass(WIRE, wire[0])) && (both[1].revents == 0 || pass(wire[0], WIRE));
    }
    int status = 1;
    (void)waitpid(controller, &status, 0);
    fprintf(stderr, "# seed %s: %u damages\n", arguments[1], damages);
    return status == 0 && damages > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
