#ifndef ISO_CLIENT_PROCESS_H
#define ISO_CLIENT_PROCESS_H

/* The plant in this process, at the address plant:PATH of its library, with the words of the link: a step is a call,
 * and no byte goes over a wire. Time is virtual: the mode is lockstep. */
#include <dlfcn.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Loads the library, and makes a plant of it. It is never unloaded: other links may have plants of it. */
static inline bool iso_client_enter(iso_client *c, const char *path)
{
    void *library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    const iso_inside *inside = library == NULL ? NULL : (const iso_inside *)dlsym(library, "iso_the_inside");
    if (inside == NULL) {
        return iso_client_fail(c, "the library of the plant", dlerror());
    }
    if (*inside->identity != c->identity) {
        return iso_client_fail(c, "refused",
                               "another plant, method, step or type of numbers: make the controller again");
    }
    c->plant = calloc(inside->bytes() / sizeof(uint64_t) + 1, sizeof(uint64_t));
    c->outputs_inside = c->plant == NULL ? NULL : inside->open(c->plant);
    if (c->outputs_inside == NULL) {
        free(c->plant);
        c->plant = NULL;
        return iso_client_fail(c, "the plant",
                               "there is no memory, or this processor, or its mode, computes other bits");
    }
    c->inside = inside;
    return true;
}

static inline bool iso_client_open(iso_client *c, const char *address)
{
    address = address == NULL ? getenv("ISOCHRON_LINK") : address;
    if (address != NULL && strncmp(address, "plant:", 6) == 0) {
        c->file = -1;
        return iso_client_enter(c, address + 6);
    }
    c->file = iso_client_connect(address);
    return c->file >= 0 || iso_client_fail(c, "the link", strerror(errno));
}

static inline void iso_client_close(iso_client *c)
{
    free(c->plant);
    c->plant = NULL;
    (void)close(c->file);
}

/* Takes the outputs of the plant, which are those of a tick. */
static inline bool iso_client_look(iso_client *c, uint64_t tick)
{
    c->tick = tick;
    memcpy(c->y, c->outputs_inside, c->outputs * c->real_bytes);
    return c->ticks == 0 || tick < c->ticks;
}

/* The answer to the command that has been begun, where iso_client_ask has it. */
static inline bool iso_client_ask_inside(iso_client *c, size_t *length)
{
    enum { PAYLOAD_AT = 3 }; /* behind the head of a frame and its type */
    const uint8_t *answer = c->inside->ask(c->plant, c->sent + PAYLOAD_AT, c->sent_used - PAYLOAD_AT, length);
    if (answer == NULL || *length < ISO_CLIENT_BYTES_OF_ANSWER) {
        return iso_client_fail(c, "refused", "there is no such command");
    }
    memcpy(c->received + 1, answer, *length);
    *length -= ISO_CLIENT_BYTES_OF_ANSWER;
    return true;
}

static inline bool iso_client_begin_run(iso_client *c, int mode, uint64_t ticks)
{
    if (c->inside == NULL) {
        return iso_client_start(c, mode, ticks);
    }
    if (mode != ISO_CLIENT_LOCKSTEP) {
        return iso_client_fail(c, "refused", "a plant in this process has no time of its own: it runs in lockstep");
    }
    c->over = false;
    c->mode = mode;
    c->ticks = ticks;
    c->inside->start(c->plant, ticks);
    return iso_client_look(c, 0);
}

static inline bool iso_client_step(iso_client *c)
{
    if (c->inside == NULL) {
        return iso_client_exchange(c);
    }
    const iso_inside_outcome outcome = c->inside->step(c->plant, c->u);
    if (outcome <= ISO_INSIDE_STEPPED_LAST) {
        (void)iso_client_look(c, c->tick + 1);
    }
    if (outcome == ISO_INSIDE_STEPPED) {
        return true;
    }
    if (outcome == ISO_INSIDE_RESTS || outcome == ISO_INSIDE_NO_RUN) {
        return iso_client_fail(c, "refused",
                               outcome == ISO_INSIDE_RESTS ? "the plant rests" : "no run has been started");
    }
    c->over = iso_client_counts(c);
    return false;
}

static inline bool iso_client_end_run(iso_client *c)
{
    if (c->inside == NULL) {
        return iso_client_stop(c);
    }
    if (!c->over && !c->inside->runs(c->plant)) {
        return iso_client_fail(c, "refused", "there is no run");
    }
    c->inside->stop(c->plant);
    c->over = c->over || iso_client_counts(c);
    return c->over;
}

#ifdef __cplusplus
}
#endif

#endif
