/* The pictures. Each function writes gnuplot's commands to the standard output: first a comment with the size,
 * `# size WIDTH HEIGHT`; nothing where there is nothing to draw. */
#ifndef ISO_TOOLS_PLOT_PICTURES_H
#define ISO_TOOLS_PLOT_PICTURES_H

#include <stddef.h>

/* All outputs of a run over time, or those of these names, a panel for each; the components of a vector share one. Exits if
 * none has such a name. */
void picture_trace(const char *directory, char *const *names, size_t count);

/* The way of the first point that is shown, in the plane in which it moves most, and the change of the energy, if there
 * is one. Nothing where there is no point. */
void picture_path(const char *directory);

/* How many steps took how long, from 0 to the period, in the bins that the summary tells. Nothing where the scene asks for no
 * histogram. */
void picture_histogram(const char *directory);

/* Error over cost and over the step for every method, from a report's table, tab-separated (tools/measure). */
void picture_work_precision(const char *scene, const char *time, const char *path);

/* The largest violation over time for every stabilisation: the lines of tools/measure/drift.c, each after the name of the
 * stabilisation; thin, what the violation may be. */
void picture_violation(const char *scene, const char *path);

/* The cost and the influence of each effect of a scene, and the scene without any, as bars: the table of tools/measure/price.c. */
void picture_effects(const char *scene, const char *target, const char *path);

/* The outputs that the runs in two folders have in common, a panel for each, one run over the other. Exits if there are none,
 * or no times in common. */
void picture_compare(const char *first, const char *second);

/* Not a picture: a table of their differences at the times that both have, the root of the mean square and the largest. */
void table_differences(const char *first, const char *second);

/* Copies a drawing of gnuplot's from the standard input without what changes nothing. Exits if its groups do not
 * match. */
void compact_svg(void);

#endif
