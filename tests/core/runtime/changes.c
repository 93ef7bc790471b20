/* What is set at times: from any tick on, with any gap before it, a plant has what a look at the whole table gives. */
#include "core/runtime/changes.h"
#include "tests/tap.h"

enum { ROWS = 9, PARAMETERS = 3, LAST = 40 };

static const iso_change table[ROWS] = {
    {0, 1, ISO_SCALAR(1.0)},  {3, 0, ISO_SCALAR(2.0)},  {3, 0, ISO_SCALAR(3.0)},
    {4, 2, ISO_SCALAR(4.0)},  {7, 0, ISO_SCALAR(5.0)},  {7, 1, ISO_SCALAR(6.0)},
    {20, 2, ISO_SCALAR(7.0)}, {20, 2, ISO_SCALAR(8.0)}, {UINT32_MAX, 0, ISO_SCALAR(9.0)},
};

/* All of the table that is due in a tick. */
static void set_by_look(real *const p, const uint32_t count, const uint64_t tick)
{
    for (uint32_t i = 0; i < count; i++) {
        p[table[i].parameter] = table[i].tick == tick ? iso_all(table[i].value) : p[table[i].parameter];
    }
}

static bool same(const real *const p, const real *const q)
{
    iso_bits differ = ISO_NOTHING;
    for (uint32_t i = 0; i < PARAMETERS; i++) {
        differ |= iso_bits_of(p[i]) ^ iso_bits_of(q[i]);
    }
    return differ == 0;
}

/* From a tick on, with so many rows of the table; `off` is added to the place, which is 0 but for the control. */
static bool follows(const uint32_t count, const uint64_t from, const uint64_t until, const uint32_t off)
{
    real p[PARAMETERS] = {R(0.0)}, q[PARAMETERS] = {R(0.0)};
    uint32_t place = iso_place_of_changes(table, count, from) + off;
    bool good = true;
    for (uint64_t tick = from; tick < until; tick++) {
        place = iso_set_due(p, table, count, place, tick);
        set_by_look(q, count, tick);
        good = good && same(p, q);
    }
    return good;
}

int main(void)
{
    bool good = true;
    for (uint32_t count = 0; count <= ROWS; count++) {
        for (uint64_t from = 0; from < LAST; from++) {
            good = good && follows(count, from, LAST, 0);
        }
    }
    tap_ok(good, "from every tick on, with every length of the table");
    const uint64_t end = UINT32_MAX;
    tap_ok(follows(ROWS, end - 2, end + 3, 0), "the last tick that a scene can name");
    tap_ok(follows(ROWS, end + 1, end + 50, 0), "nothing is due behind it, where the low word is that of the begin");
    tap_ok(!follows(ROWS, 4, LAST, 1), "control: one place behind is found");
    tap_done();
}
