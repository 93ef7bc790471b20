/* A text as a scene, through the whole of isoc, with options that follow from the text: whatever it says, isoc ends,
 * and gives all memory back. */
#define _GNU_SOURCE
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

/* That of tools/isoc/main.c. */
int isoc_main(int count, char **arguments);

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count);

/* The first set writes no plant. */
static char *const options[][5] = {
    {"--mjcf"},
    {NULL},
    {"--real", "double", "--method", "bdf4"},
    {"--method", "rosenbrock"},
    {"--method", "adams", "--tolerance", "1e-6"},
    {"--method", "bdf4", "--factors", "looped"},
    {"--formulation", "legs"},
    {"--formulation", "articulated"},
    {"--inputs", "smooth"},
    {"--fmu"},
    {"--fmu", "--fmi", "2", "--exchange"},
    {"--linear", "--trim", "rest"},
    {"--link", "--xcp", "open"},
    {"--python"},
    {"--standalone", "--name", "fuzzed"},
    {"--lanes"},
};

static char *const *options_of(const uint8_t *const bytes, const size_t count)
{
    uint32_t hash = 0;
    for (size_t i = 0; i < count; i++) {
        hash = 31 * hash + bytes[i];
    }
    return options[hash % (sizeof options / sizeof options[0])];
}

int LLVMFuzzerTestOneInput(const uint8_t *const bytes, const size_t count)
{
    const int file = memfd_create("scene", 0);
    char path[32];
    if (file < 0 || write(file, bytes, count) != (ssize_t)count) {
        abort();
    }
    snprintf(path, sizeof path, "/proc/self/fd/%d", file);
    char *arguments[9] = {"isoc", path, "-o", getenv("FUZZ_OUT")};
    char *const *const chosen = options_of(bytes, count);
    int length = chosen == options[0] ? 2 : 4;
    for (size_t i = 0; chosen[i] != NULL; i++) {
        arguments[length++] = chosen[i];
    }
    arguments[length] = NULL;
    (void)isoc_main(length, arguments);
    close(file);
    return 0;
}
