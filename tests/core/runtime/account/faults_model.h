/* The model of tests/core/runtime/account/faults.c, which includes it behind what happens in a tick: it adds up the
 * account by itself, in numbers of ticks of the port. */
#ifndef ISO_TESTS_ACCOUNT_FAULTS_MODEL_H
#define ISO_TESTS_ACCOUNT_FAULTS_MODEL_H

typedef struct snapshot {
    real x[2], input, admitted, tunable, outputs[2];
    uint64_t tick, hash;
} snapshot;

static struct {
    int64_t late, lost, overruns, margin, shortest, longest, sum;
    int64_t inputs_held, inputs_clamped, tunables_held, outputs_held;
    int64_t inputs, inputs_late, repeated, stale, missing, safe, damaged, refused;
    int64_t done, not_done, moves, rests, faults;
    snapshot is, kept;
    enum { EMPTY, WHOLE, SPOILT } record;
    int64_t time, ticks, reported; /* of the port: those that have passed, and the latest that it told of */
    int64_t answered, age, burst;
    bool fresh, runs, one;
    real value; /* that came last */
} m = {.margin = INT64_MAX, .shortest = INT64_MAX, .runs = true};

static void model_wait(void)
{
    int64_t awake = m.reported + 1;
    while (is_lost((uint64_t)awake)) {
        m.faults++;
        awake++;
    }
    const int64_t delay = (int64_t)span((uint64_t)awake, DELAY), at = awake * PERIOD + delay;
    m.faults += delay > 0;
    m.time = at > m.time ? at : m.time;
    m.reported = m.time / PERIOD;
}

static void model_command(const enum command asked)
{
    const bool is_whole = m.record == WHOLE;
    m.faults += asked != NOTHING;
    m.refused += asked == NO_COMMAND || asked == NO_LENGTH;
    m.not_done += asked == NO_PIECE || asked == SHORT || (asked == RESTORE && !is_whole);
    m.done += asked == TAKE || asked == SPOIL || asked == PAUSE || asked == ONE || asked == AGAIN;
    m.done += asked == RESTORE ? is_whole ? 2 : 1 : 0;
    switch (asked) {
    case TAKE:
        m.kept = m.is;
        m.record = WHOLE;
        break;
    case SPOIL:
        m.record = SPOILT;
        break;
    case RESTORE:
        if (is_whole) {
            m.moves++;
            m.is = m.kept;
            m.answered = (int64_t)m.is.tick;
            m.age = 0;
            m.value = m.is.input;
        }
        m.runs = true;
        m.one = false;
        break;
    case PAUSE:
        m.runs = false;
        break;
    case ONE:
    case AGAIN:
        m.runs = m.one = true;
        break;
    default:
        break;
    }
}

static void model_frame(const enum stream how, const int64_t tick, const real value)
{
    const int64_t answers = tick + (how == FUTURE ? 1 : how == BEHIND ? -1 : how == OLD ? -3 : 0);
    m.faults += how != WELL;
    m.damaged += how == WRONG_BYTE || how == CUT_OFF || how == GARBAGE;
    if (how == NO_FRAME || how == WRONG_BYTE || how == CUT_OFF || how == GARBAGE) {
        return;
    }
    if (answers < 0 || answers > tick || answers < m.answered - 1) { /* before tick 0: as many as 2^64 less */
        m.stale++;
    } else if (answers == m.answered - 1) {
        m.repeated++;
    } else {
        m.inputs++;
        m.inputs_late += answers < tick;
        m.repeated += how == TWICE;
        m.answered = answers + 1;
        m.value = value;
        m.fresh = true;
    }
}

/* A plant that rests: time goes on until it is told to run; the ticks that have come due by then pass. */
static void model_rest(const uint64_t k)
{
    const uint64_t bits = chance(k, IDLE);
    m.rests++;
    m.time += (int64_t)((bits >> 8) % 3 + 1) * (int64_t)(bits % 5) * (PERIOD / 2);
    m.done++;
    m.runs = true;
    m.one = false;
    if (m.time >= (m.ticks + 1) * PERIOD) {
        model_wait();
        m.ticks = m.reported;
    }
}

static void model_values(const uint64_t k)
{
    const real tunable = given(k, TUNABLE), made = given(k + 1, OUTPUT);
    snapshot *const s = &m.is;
    m.age = m.fresh ? 0 : m.age + 1;
    m.missing += !m.fresh;
    m.safe += m.age >= SAFE_AFTER;
    const real came = m.age >= SAFE_AFTER ? SAFE : m.answered > 0 ? m.value : s->input;
    m.fresh = false;
    m.faults += !(fabs((double)came) <= 1.0);
    m.inputs_held += !isfinite(came);
    m.inputs_clamped += isfinite(came) && (came < R(-0.5) || came > R(0.75));
    if (isfinite(came)) {
        s->admitted = came < R(-0.5) ? R(-0.5) : came > R(0.75) ? R(0.75) : came;
    }
    s->input = m.value = s->admitted;
    m.faults += !isfinite(tunable);
    m.tunables_held += !isfinite(tunable);
    s->tunable = isfinite(tunable) ? tunable : s->tunable;
    s->x[0] = s->input + s->x[0] / R(2.0);
    s->x[1] = s->x[1] / R(4.0) - s->x[0];
    m.outputs_held += !isfinite(made);
    if (isfinite(made)) {
        s->outputs[0] = s->x[0];
        s->outputs[1] = made;
    }
}

static void model_time(const uint64_t k)
{
    if (m.reported <= m.ticks) {
        model_wait();
    }
    const int64_t cost = (int64_t)span(k, COST);
    m.faults += cost > 0;
    m.ticks++;
    m.late += m.time - m.ticks * PERIOD > LATE;
    m.lost += m.ticks < m.reported;
    m.time += cost;
    const int64_t left = (m.ticks + 1) * PERIOD - m.time;
    m.overruns += left < 0;
    m.margin = left < m.margin ? left : m.margin;
    m.shortest = cost < m.shortest ? cost : m.shortest;
    m.longest = cost > m.longest ? cost : m.longest;
    m.sum += cost;
}

static void model_hash(void)
{
    uint8_t bytes[sizeof m.is.x];
    memcpy(bytes, m.is.x, sizeof bytes);
    for (size_t i = 0; i < sizeof bytes; i++) {
        m.is.hash = (m.is.hash ^ bytes[i]) * UINT64_C(1099511628211);
    }
}

static void model_tick(const uint64_t k)
{
    const enum command asked = command_of(k);
    m.burst = fault(k, BURST, 3000) != 0 ? 1 + 2 * SAFE_AFTER : m.burst - (m.burst > 0);
    m.faults += m.burst > 0;
    const int64_t tick = (int64_t)m.is.tick;
    model_command(asked);
    if (m.burst == 0 && asked != RESTORE) {
        model_frame(stream_of(k), tick, given(k, INPUT));
    }
    if (!m.runs) {
        model_rest(k);
    }
    model_time(k);
    model_values(k);
    model_hash();
    m.is.tick++;
    m.runs = !m.one;
}

#endif
