/* The policies of the loop on ticks that do not keep their time, and its further counts of them: the statements
 * `overrun`, `grace`, `publish` and `histogram` of a scene. A plant without these statements has no policy; for the
 * others isoc writes an `account` that calls the functions below. The loop calls it after each tick with news, and
 * counts, times and skips by integers alone. */
#ifndef ISO_CORE_RUNTIME_POLICY_H
#define ISO_CORE_RUNTIME_POLICY_H

#include "core/runtime/loop.h"
#include "core/runtime/policy_counts.h"

/* grace: late starts and overruns of the first ticks are counted apart. */
static inline void iso_policy_grace(iso_loop *const loop, iso_policy_counts *const counts, const iso_news *const news,
                                    const uint32_t ticks)
{
    if (loop->tick <= ticks) {
        counts->grace_late += news->late;
        counts->grace_overruns += news->overran;
        loop->statistics.late -= news->late;
        loop->statistics.overruns -= news->overran;
    }
}

/* overrun catch_up: of the ticks that are due, so many are done; the others pass without a step, as while the plant
 * rests: its time stands still, and its trajectory is that of the ticks that were done. */
static inline void iso_policy_catch_up(iso_loop *const loop, iso_policy_counts *const counts, const uint32_t most)
{
    const uint64_t behind = loop->reported - loop->tick;
    if (behind > most) {
        const uint64_t passed = behind - most;
        counts->skipped_first = counts->skipped == 0 ? loop->tick + loop->rested + 1 : counts->skipped_first;
        counts->skipped += passed;
        loop->rested += passed;
        loop->reported -= passed;
        loop->due += passed * loop->period;
        counts->skipped_last = loop->tick + loop->rested;
    }
}

/* overrun stop: the first tick that ends after the next one was due ends the run. */
static inline bool iso_policy_stop(const iso_loop *const loop, iso_policy_counts *const counts,
                                   const iso_news *const news, const uint32_t grace)
{
    const bool stops = news->overran && loop->tick > grace;
    counts->stopped = stops ? loop->tick : 0;
    return !stops;
}

/* The begin of a run: all counts are 0, and the method is that of the scene. */
static inline void iso_policy_reset(const iso_policy *const policy)
{
    memset(policy->counts, 0, policy->count * sizeof(uint64_t));
    policy->counts->latency = policy->delays;
}

/* overrun degrade: an overrun leads one rung down, so many ticks without one lead one up again. */
static inline void iso_policy_degrade(iso_loop *const loop, iso_policy_counts *const counts, const iso_news *const news,
                                      const uint32_t grace, const uint32_t rungs, const uint32_t after)
{
    counts->degraded += counts->rung > 0;
    counts->good++;
    if (news->overran && loop->tick > grace) {
        counts->rung += counts->rung < rungs;
        counts->good = 0;
    } else if (counts->rung > 0 && counts->good >= after) {
        counts->rung--;
        counts->good = 0;
    }
    counts->lowest = counts->lowest < counts->rung ? counts->rung : counts->lowest;
    if (counts->rung > 0) {
        loop->execution_min = UINT32_MAX; /* each tick there is one with news */
    }
}

/* A step by a method of the ladder; values that follow from parameters are computed first, if one changed. */
static inline bool iso_policy_attempt(const iso_plant *const plant, void (*const step)(void *memory))
{
    const iso_model *const model = plant->model;
    const bool restarts = model->discontinuity != NULL && model->discontinuity(plant->memory);
    if (restarts) {
        model->prime(plant->memory);
    }
    step(plant->memory);
    return restarts;
}

/* histogram: every tick is one with news. */
static inline void iso_policy_bin(iso_loop *const loop, iso_policy_histogram *const histogram,
                                  const iso_news *const news)
{
    const uint32_t width = loop->period / ISO_HISTOGRAM_BINS;
    const uint32_t last = ISO_HISTOGRAM_BINS - 1;
    histogram->width = width;
    histogram->bins[news->counts < (uint64_t)width * last ? (uint32_t)news->counts / width : last]++;
    loop->execution_min = UINT32_MAX;
}

#endif
