/* The counts of policies on ticks that do not keep their time, and how the loop calls them (core/runtime/policy.h). */
#ifndef ISO_CORE_RUNTIME_POLICY_COUNTS_H
#define ISO_CORE_RUNTIME_POLICY_COUNTS_H

#include <stdbool.h>
#include <stdint.h>

struct iso_loop;

/* A tick with news. */
typedef struct iso_news {
    uint64_t counts; /* of its step */
    bool late, overran;
} iso_news;

enum { ISO_HISTOGRAM_BINS = 32 };

/* The counts, one after another, 64 bits each. */
#define ISO_POLICY_COUNTS(X)                                                                                           \
    X(skipped)       /* ticks of the port that nothing was done for */                                                 \
    X(skipped_first) /* the number of the first, as the port counts */                                                 \
    X(skipped_last)                                                                                                    \
    X(grace_late) /* ticks within the grace */                                                                         \
    X(grace_overruns)                                                                                                  \
    X(stopped)  /* the tick that ended the run by its overrun; 0: none did */                                          \
    X(latency)  /* ticks from the end of a step to its outputs */                                                      \
    X(rung)     /* of the ladder, of the next step; 0: the method of the scene */                                      \
    X(good)     /* ticks on this rung without an overrun */                                                            \
    X(degraded) /* ticks on a rung below the method of the scene */                                                    \
    X(lowest)   /* rung, counted downwards */

#define ISO_POLICY_MEMBER(name) uint64_t name;
typedef struct iso_policy_counts {
    ISO_POLICY_COUNTS(ISO_POLICY_MEMBER)
} iso_policy_counts;

/* The counts with a histogram of execution times: bin i of those from i widths on, the last of all above. */
typedef struct iso_policy_histogram {
    iso_policy_counts counts;
    uint64_t width; /* a 32nd of the period, rounded down */
    uint64_t bins[ISO_HISTOGRAM_BINS];
} iso_policy_histogram;

typedef struct iso_policy {
    bool (*account)(struct iso_loop *loop, const iso_news *news); /* returns whether the run goes on */
    iso_policy_counts *counts;
    uint16_t count; /* of words there: those of a histogram are behind them */
    uint16_t rungs; /* of a ladder, below the method of the scene; 0: there is none */
    bool delays;    /* outputs are published when the next tick begins */
} iso_policy;

#endif
