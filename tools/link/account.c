#include "tools/link/link.h"

#include <stdlib.h>
#include <string.h>

#include "tools/file/file.h"

enum {
    TICK_BYTES = 0 ISO_LINK_INPUTS_FIELDS(ISO_FIELD_BYTES),
    ANSWER_BYTES = 0 ISO_LINK_ANSWER_FIELDS(ISO_FIELD_BYTES),
};

static void take_end(account *const a, const uint8_t *const payload)
{
    uint64_t words[ISO_LINK_END_WORDS];
    for (size_t i = 0; i < ISO_LINK_END_WORDS; i++) {
        words[i] = iso_frame_number(payload + i * sizeof words[i], sizeof words[i]);
    }
    _Static_assert(sizeof a->end == sizeof words, "the end has the words of the frame, in their order");
    memcpy(&a->end, words, sizeof words);
    a->ended = true;
}

/* Outputs of a tick: those of the next row, or of one to which a command has put the plant. */
static void take_outputs(account *const a, const uint64_t tick, const uint64_t now)
{
    if (a->moved) {
        memset(a->shown, 0, sizeof a->shown);
    } else if (tick > a->newest) {
        if (tick == a->newest + 1) {
            a->rounds = room_behind(a->rounds, a->round_count, sizeof *a->rounds);
            a->rounds[a->round_count++] = now - a->arrival;
        }
        a->row += tick - a->newest;
    } else if (tick > 0) {
        return;
    }
    a->moved = false;
    a->arrival = now;
    a->newest = tick;
    a->shown[tick % ACCOUNT_OPEN] = now;
}

static bool is_move(const uint8_t *const answer)
{
    return answer[2] == ISO_CONTROL_DONE && (answer[0] == ISO_COMMAND_RESET || answer[0] == ISO_COMMAND_RESTORE);
}

void account_plant(account *const a, const uint8_t type, const uint8_t *const payload, const size_t length,
                   const uint64_t now)
{
    if (type == ISO_LINK_OUTPUTS && length >= TICK_BYTES) {
        take_outputs(a, iso_frame_number(payload, TICK_BYTES), now);
    } else if (type == ISO_LINK_ANSWER && length >= ANSWER_BYTES && is_move(payload)) {
        a->moved = true;
    } else if (type == ISO_LINK_END && length == ISO_LINK_END_BYTES) {
        take_end(a, payload);
    }
}

void account_controller(account *const a, const uint8_t type, const uint8_t *const payload, const size_t length,
                        const uint64_t now)
{
    if (type != ISO_LINK_INPUTS || length < TICK_BYTES) {
        return;
    }
    const uint64_t tick = iso_frame_number(payload, TICK_BYTES);
    uint64_t *const shown = &a->shown[tick % ACCOUNT_OPEN];
    const size_t bytes = length - TICK_BYTES;
    if (tick > a->newest || a->newest - tick >= ACCOUNT_OPEN || *shown == 0 ||
        (a->exchanges > 0 && bytes != a->input_bytes)) {
        return;
    }
    a->trips = room_behind(a->trips, a->exchanges, sizeof *a->trips);
    a->answered = room_behind(a->answered, a->exchanges, sizeof *a->answered);
    a->inputs = room_behind(a->inputs, a->exchanges, bytes);
    a->input_bytes = bytes;
    a->trips[a->exchanges] = now - *shown;
    a->answered[a->exchanges] = a->row - (a->newest - tick);
    memcpy(a->inputs + a->exchanges * bytes, payload + TICK_BYTES, bytes);
    a->exchanges++;
    *shown = 0;
}

static int compare(const void *const a, const void *const b)
{
    const uint64_t x = *(const uint64_t *)a;
    const uint64_t y = *(const uint64_t *)b;
    return (x > y) - (x < y);
}

/* Sorts times; *median and the longest are 0 where there are none. */
static uint64_t longest_of(uint64_t *const all, const size_t count, uint64_t *const median)
{
    if (count > 0) {
        qsort(all, count, sizeof *all, compare);
    }
    *median = count > 0 ? all[count / 2] : 0;
    return count > 0 ? all[count - 1] : 0;
}

account_trips account_sum(account *const a)
{
    account_trips sum = {.count = a->exchanges};
    const uint64_t rows = a->row + (a->end.tick - a->newest);
    while (sum.count > 0 && a->answered[sum.count - 1] >= rows) {
        sum.count--;
    }
    sum.longest = longest_of(a->trips, sum.count, &sum.median);
    sum.whole_longest = longest_of(a->rounds, a->round_count, &sum.whole_median);
    return sum;
}

void account_free(account *const a)
{
    free(a->trips);
    free(a->rounds);
    free(a->answered);
    free(a->inputs);
}
