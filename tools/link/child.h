/* Programs that are started here and ended here. */
#ifndef ISO_TOOLS_LINK_CHILD_H
#define ISO_TOOLS_LINK_CHILD_H

#include <stdbool.h>
#include <sys/types.h>

/* All zeros where it was not started: then it has ended well. */
typedef struct child {
    const char *name; /* for messages */
    pid_t id;
    bool running;
    int status; /* of waitpid, when it does not run */
} child;

/* Starts a command in a process group of its own, with nothing to read. The environment has `variable` set to `value`;
 * the descriptor `file`, if it is not negative, is number `number` there. Exits if it cannot. */
child child_start(const char *name, char *const *command, const char *variable, const char *value, int file,
                  int number);

/* Whether it runs; does not wait. */
bool child_runs(child *c);

/* Whether it ends within so many milliseconds. */
bool child_ends(child *c, int milliseconds);

/* Ends it and all that it has started: by a request, and after half a second by force. */
void child_stop(child *c);

/* How it ended, in words; NULL if well. */
const char *child_fault(const child *c);

#endif
