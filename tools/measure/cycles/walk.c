#include "tools/measure/cycles/cycles.h"

#include <stdlib.h>
#include <string.h>

#include "tools/file/file.h"

enum { DEPTH_MOST = 64, INTEGERS = 16 };

/* A pipeline in which instructions begin in order: how long each takes, and when its results can be taken. All in half
 * cycles, by the least or by the most that the table allows. */
typedef struct pipeline {
    int64_t now;
    int64_t ready[REGISTERS];     /* when the next instruction can take it */
    int64_t addressed[REGISTERS]; /* likewise, in an address */
} pipeline;

typedef struct frame {
    uint32_t back; /* where it returns to */
    size_t part;
    int32_t stack;
    bool is_interrupt;
    const instruction *before; /* of an interrupt: the instruction before it */
    uint32_t address;          /* likewise */
} frame;

typedef struct walker {
    const walk_plan *plan;
    walk_result *result;
    call present;
    frame frames[DEPTH_MOST];
    int depth;                 /* of frames; 0 outside of a call of the entry */
    const instruction *before; /* the last instruction; NULL: unknown */
    const instruction *leader; /* the instruction directly before `before` */
    uint32_t address;          /* of before */
    pipeline least, most;
    int32_t stack;
    uint32_t stack_at_entry;
    int32_t stack_of_part; /* where the present part began */
    uint64_t cycle;        /* before `before`, by the simulator */
    uint32_t constants[INTEGERS];
    amount interrupt;
    amount rested[PARTS_MOST + 1][KINDS]; /* of the present call, when it slept first */
    bool has_rested;
} walker;

static int32_t of(const bound b, const bool most)
{
    return most ? b.most : b.least;
}

/* The half cycles that an instruction takes, with *waits of them for operands that are not ready. */
static int64_t pass(pipeline *const p, const instruction *const i, const bool pipelined, const bool taken,
                    const uint32_t skipped, const bool most, int64_t *const waits)
{
    const rule *const r = i->rule;
    int64_t begin = p->now;
    for (registers set = i->reads | i->addresses; set != 0; set &= set - 1) {
        const int n = __builtin_ctzll(set);
        const int64_t ready = (i->addresses >> n & 1) != 0 ? p->addressed[n] : p->ready[n];
        begin = ready > begin ? ready : begin;
    }
    *waits = begin - p->now;
    int64_t cycles = of(r->cycles, most) + i->words * of(r->each, most) + (taken ? of(r->taken, most) : 0) +
                     (int64_t)skipped * HALVES;
    cycles += (i->is_indexed ? of(r->indexed, most) : 0) + (i->is_literal ? of(r->literal, most) : 0);
    cycles -= pipelined && cycles > HALVES ? HALVES : 0;
    const int64_t end = begin + cycles;
    for (registers set = i->writes; set != 0; set &= set - 1) {
        const int n = __builtin_ctzll(set);
        p->ready[n] = end + of(r->late, most);
        p->addressed[n] = end + of(r->late_addressed, most);
        p->addressed[n] = p->addressed[n] > p->ready[n] ? p->addressed[n] : p->ready[n];
    }
    const int64_t took = end - p->now;
    p->now = end;
    return took;
}

static void add(amount *const a, const amount b)
{
    a->instructions += b.instructions;
    a->least += b.least;
    a->most += b.most;
    a->counted += b.counted;
}

/* A processor may sleep several times until a tick is due; instructions between the first and the last sleep do not
 * count. */
static void rest(walker *const w)
{
    if (w->has_rested) {
        memcpy(w->present.amounts, w->rested, sizeof w->rested);
    }
    memcpy(w->rested, w->present.amounts, sizeof w->rested);
    w->has_rested = true;
}

/* Accounts the instruction before, now that the next one is known; `interrupted`: that is of an interrupt. */
static void account(walker *const w, const executed *const e, const bool interrupted)
{
    const instruction *const i = w->before;
    const size_t present = w->frames[w->depth - 1].part;
    if (i->rule == NULL) {
        quit("cycles: the table of the %s has no rule for the instruction %s", w->plan->core->name,
             i->bytes == 0 ? "that is not in the listing" : i->name);
    }
    const bool jumps = e->address != w->address + i->bytes && !interrupted;
    const bool skips = (i->rule->use & SKIPS) != 0;
    const uint32_t skipped = jumps && skips ? (e->address - w->address - i->bytes) / 2 : 0;
    const bool pipelined = w->leader != NULL && (w->leader->rule->use & LEADS) != 0 && (i->rule->use & FOLLOWS) != 0 &&
                           (w->leader->writes & i->addresses) == 0;
    int64_t waits_least = 0, waits_most = 0;
    const int64_t least = pass(&w->least, i, pipelined, jumps && !skips, skipped, false, &waits_least);
    const int64_t most = pass(&w->most, i, pipelined, jumps && !skips, skipped, true, &waits_most);
    if (present != 0 && present == w->plan->interrupt) {
        add(&w->interrupt, (amount){1, least, most, e->cycle - w->cycle});
        return;
    }
    const bool spills = i->at_stack && (i->rule->kind == LOAD || i->rule->kind == STORE);
    amount *const amounts = w->present.amounts[present];
    const bool rests = (i->rule->use & RESTS) != 0;
    const uint64_t counted = rests && e->cycle > 0 ? (uint64_t)(most / HALVES) : e->cycle - w->cycle;
    add(&amounts[spills ? SPILL : (int)i->rule->kind], (amount){1, least - waits_least, most - waits_most, counted});
    add(&amounts[WAIT], (amount){0, waits_least, waits_most, 0});
    if (rests) {
        rest(w);
    }
}

/* The stack before an instruction: from the trace, or from the changes of all instructions before. */
static void follow_stack(walker *const w, const executed *const e)
{
    if (e->has_stack) {
        w->stack = (int32_t)(w->stack_at_entry - e->stack);
    } else if (w->before != NULL) {
        w->stack += w->before->pushes;
        if (w->before->grows_by >= 0) {
            const int32_t by = -(int32_t)w->constants[w->before->grows_by];
            w->stack += by > 0 ? by : 0;
        }
        if (w->before->loads >= 0) {
            const uint32_t at = w->before->constant / 2;
            w->constants[w->before->loads] = at < w->plan->listing->words ? w->plan->listing->constant[at] : 0;
        }
    }
    const size_t present = w->frames[w->depth - 1].part;
    if (present == 0 || present != w->plan->interrupt) {
        w->present.stack = w->stack > w->present.stack ? w->stack : w->present.stack;
    }
    if (w->stack - w->stack_of_part > w->present.stack_of[present]) {
        w->present.stack_of[present] = w->stack - w->stack_of_part;
    }
}

/* A part holds for all that is called in it. A function that is left out is left out of every part; within it another
 * part can begin. */
static void push(walker *const w, const uint32_t back, const size_t called)
{
    if (w->depth == DEPTH_MOST) {
        quit("cycles: the calls of the trace are too deep");
    }
    const size_t around = w->depth > 0 ? w->frames[w->depth - 1].part : 0;
    const bool begins = called != 0 && (around == 0 || around == w->plan->left_out || called == w->plan->left_out);
    w->frames[w->depth++] = (frame){.back = back, .part = begins ? called : around, .stack = w->stack};
    if (begins) {
        w->stack_of_part = w->stack;
    }
}

static void begin_interrupt(walker *const w)
{
    w->interrupt = (amount){0};
    push(w, 0, 0);
    frame *const top = &w->frames[w->depth - 1];
    top->part = w->plan->interrupt;
    top->is_interrupt = true;
    top->before = w->before;
    top->address = w->address;
    w->before = NULL;
}

static void end_interrupt(walker *const w, const frame *const ended)
{
    if (w->interrupt.most > w->present.interrupt.most) {
        w->present.interrupt = w->interrupt;
    }
    w->before = ended->before;
    w->address = ended->address;
}

/* A call of the entry has returned. */
static void finish_call(walker *const w)
{
    walk_result *const r = w->result;
    w->present.number = ++r->calls;
    const amount all = call_total(w->plan, &w->present);
    const amount dearest = call_total(w->plan, &r->dearest);
    r->last = w->present;
    if (r->calls == 1 || all.most > dearest.most) {
        r->dearest = w->present;
    }
    r->least = r->calls == 1 || all.instructions < r->least ? all.instructions : r->least;
    r->longest = all.instructions > r->most ? r->calls : r->longest;
    r->most = all.instructions > r->most ? all.instructions : r->most;
    r->all += all.instructions;
    r->sum += all.most;
}

/* Ends the frames that return to this address, and begins one if the instruction before called. */
static void follow_calls(walker *const w, const executed *const e, const instruction *const i)
{
    for (bool first = true; w->depth > 0; first = false) {
        const frame ended = w->frames[w->depth - 1];
        if (ended.is_interrupt ? !first || w->before == NULL || !w->before->leaves : ended.back != e->address) {
            break;
        }
        w->depth--;
        w->stack = ended.stack;
        if (ended.is_interrupt) {
            end_interrupt(w, &ended);
        } else if (w->depth == 0) {
            finish_call(w);
            return;
        }
    }
    const uint32_t back = w->before == NULL ? 0 : w->address + w->before->bytes;
    if (w->depth > 0 && w->before != NULL && (w->before->rule->use & CALLS) != 0) {
        if (back != e->address) { /* a call of the next instruction only makes room on the stack */
            push(w, back, (size_t)i->part);
        }
    } else if (w->depth > 0 && i->part != 0 && w->frames[w->depth - 1].part == 0) {
        w->frames[w->depth - 1].part = (size_t)i->part; /* by a jump at the end of a function */
        w->stack_of_part = w->stack;
    }
}

static void begin_call(walker *const w, const executed *const e)
{
    w->present = (call){0};
    w->least = w->most = (pipeline){0};
    w->has_rested = false;
    w->stack = 0;
    w->stack_at_entry = e->stack;
    push(w, w->address + w->before->bytes, 0);
}

/* One instruction of the trace. */
static void step(walker *const w, const executed *const e, const instruction *const i)
{
    const bool in_interrupt = w->depth > 0 && w->frames[w->depth - 1].part == w->plan->interrupt;
    const bool interrupts = w->depth > 0 && i->part != 0 && (size_t)i->part == w->plan->interrupt && !in_interrupt;
    if (w->depth > 0 && w->before != NULL) {
        account(w, e, interrupts);
        follow_stack(w, e);
    }
    const instruction *const before = w->before;
    if (interrupts) {
        begin_interrupt(w);
    } else {
        follow_calls(w, e, i);
    }
    w->leader = w->before == before ? before : NULL;
    if (w->depth == 0 && e->address == w->plan->listing->entry && w->before != NULL) {
        begin_call(w, e);
        w->leader = NULL;
    }
    w->before = i;
    w->address = e->address;
    w->cycle = e->cycle;
}

void walk(const walk_plan *const plan, walk_result *const result)
{
    walker *const w = memory_for(1, sizeof *w);
    executed e;
    w->plan = plan;
    w->result = result;
    *result = (walk_result){0};
    while (trace_next(&e)) {
        const instruction *const i = listing_at(plan->listing, e.address);
        if (i == NULL || i->bytes == 0) {
            quit("cycles: the trace leaves the listing at %x", (unsigned)e.address);
        }
        step(w, &e, i);
    }
    free(w);
}

amount part_total(const call *const c, const size_t number)
{
    amount sum = {0};
    for (size_t k = 0; k < KINDS; k++) {
        add(&sum, c->amounts[number][k]);
    }
    return sum;
}

amount call_total(const walk_plan *const plan, const call *const c)
{
    amount sum = {0};
    for (size_t g = 0; g <= plan->count; g++) {
        if (g == 0 || g != plan->left_out) {
            add(&sum, part_total(c, g));
        }
    }
    return sum;
}
