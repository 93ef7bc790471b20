/* The computations of make report and make bench. Each function is one of the program's commands and writes to the standard
 * output; 0 is its exit status where all is well. */
#ifndef ISO_TOOLS_ACCURACY_ACCURACY_H
#define ISO_TOOLS_ACCURACY_ACCURACY_H

/* How long to measure, about NANOSECONDS in steps of STEP seconds: the number of steps four times as long, the time that
 * they make, and the tick of a method that chooses its steps. */
int plan(const char *nanoseconds, const char *step);

/* A line of the reference from two of tools/measure/drive.c on the standard input: TIME, how far the two states are apart
 * (2-norm), and the first of them. Fails unless that is at most TOLERANCE (1 + the norm of the state). */
int agree(const char *time, const char *tolerance);

/* The table of a report, tab-separated, of what was measured: lines of a kind, a method, the instructions of a step, the
 * tolerance of adams, else `-`, and a line of drive.c. */
int errors(const char *reference_path, const char *points_path);

/* The same table as text. */
int text(const char *table_path);

/* With a program of drive.c, at TIME: the errors with 2 and with 4 COARSEST steps, and the fewest steps from which on the
 * error stays at most ERROR, 0 if those are shorter than 1 us. */
int fewest(const char *drive, const char *time, const char *coarsest, const char *error, const char *reference_path);

/* With one that takes a tolerance: the steps with the largest from which on the error stays at most ERROR, and that
 * tolerance; zeros if there is none. */
int loosest(const char *drive, const char *time, const char *error, const char *reference_path);

/* The table of make bench, and what it answers. METHODS is what `build/isoc --methods` prints; a line of MEASURED is a
 * method, what `fewest` or `loosest` found (`- -` for the errors of the latter), the instructions of a step and, where
 * steps vary, its evaluations. */
int bench(const char *methods_path, const char *measured_path, const char *time, const char *step, const char *error);

/* The table of make bench of a loop, and what wins. A line of MEASURED is a method, what `fewest` found with held inputs and
 * with smooth ones, `-` where there are none, and the instructions of a step with either. */
int loop(const char *measured_path, const char *time, const char *step, const char *error);

#endif
