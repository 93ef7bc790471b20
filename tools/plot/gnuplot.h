/* Commands for gnuplot that all pictures share; they go to the standard output. */
#ifndef ISO_TOOLS_PLOT_GNUPLOT_H
#define ISO_TOOLS_PLOT_GNUPLOT_H

#include <stdbool.h>

/* Axes, tics and grid. */
void gnuplot_style(void);

/* A text in quotes. */
void gnuplot_text(const char *text);

/* The place of a panel, as fractions of the picture from its left and lower edges. */
void gnuplot_panel(double left, double right, double top, double bottom);

/* A linear axis, 'x' or 'y', over the values from `least` to `most` with some air, and two to five tics at multiples of
 * 1, 2 or 5 times a power of ten, labelled with as many digits as they need. */
void gnuplot_range(char axis, double least, double most);

/* A logarithmic axis from `least` to `most`, with tics, and labels if it is to have them, where the value of each is. Gnuplot, told to place tics of a
 * logarithmic axis by a factor alone, begins with the end of the axis and labels it as the decade below. */
void gnuplot_decades(char axis, double least, double most, bool labels);

#endif
