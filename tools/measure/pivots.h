/* Included before a plant with closed loops (cc -include): it passes the pivots that the plant watches after each step
 * to nearness.c. */
#ifndef ISO_REPORT_PIVOTS_H
#define ISO_REPORT_PIVOTS_H

#include <string.h>

#include "core/methods/pivots.h"

enum { REPORT_PIVOTS_MOST = 512 };

extern real report_pivots[REPORT_PIVOTS_MOST];
extern size_t report_pivot_count;

static inline iso_bits report_watch(real *const last, const real *const now, const uint16_t *const closures,
                                    const size_t count, iso_nearness *const nearness)
{
    report_pivot_count = count < REPORT_PIVOTS_MOST ? count : REPORT_PIVOTS_MOST;
    memcpy(report_pivots, now, report_pivot_count * sizeof *now);
    return iso_watch_pivots(last, now, closures, count, nearness);
}

#define iso_watch_pivots report_watch

#endif
