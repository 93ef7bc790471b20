#include "tools/plot/gnuplot.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

void gnuplot_style(void)
{
    puts("set border 3 linewidth 0.8 linecolor rgb '#555555'");
    puts("set tics nomirror out scale 0.6 textcolor rgb '#333333'");
    puts("set grid linetype 1 linecolor rgb '#d4d4d4' linewidth 0.7");
    puts("set format '%g'");
    puts("set key off");
}

void gnuplot_text(const char *const text)
{
    putchar('\'');
    for (const char *c = text; *c != '\0'; c++) {
        fputs(*c == '\'' ? "''" : (char[]){*c, '\0'}, stdout);
    }
    putchar('\'');
}

void gnuplot_panel(const double left, const double right, const double top, const double bottom)
{
    printf("set lmargin at screen %.5f\nset rmargin at screen %.5f\n", left, right);
    printf("set tmargin at screen %.5f\nset bmargin at screen %.5f\n", top, bottom);
}

void gnuplot_range(const char axis, const double least, const double most)
{
    double air = 0.06 * (most - least);
    if (air == 0) {
        air = least == 0 ? 1 : 0.1 * fabs(least);
    }
    const double half = (most - least + 2 * air) / 2;
    const double decade = pow(10, floor(log10(half)));
    const double tic = decade * (half >= 5 * decade ? 5 : half >= 2 * decade ? 2 : 1);
    const int first = (int)ceil((least - air) / tic);
    const int last = (int)floor((most + air) / tic);
    const double greatest = tic * fmax(1, fmax(abs(first), abs(last)));
    const int digits = (int)fmax(6, 1 + floor(log10(greatest)) - floor(log10(tic)));
    printf("set %crange [%.9g:%.9g]\nset %ctics (", axis, least - air, most + air, axis);
    for (int i = first; i <= last; i++) {
        printf("%s'%.*g' %.12g", i == first ? "" : ", ", digits, i * tic, i * tic);
    }
    puts(")");
}

/* Labels at powers of ten, so many decades apart that there are at most six; over less than two decades at 2 and 5 times
 * such a power as well. */
void gnuplot_decades(const char axis, const double least, const double most, const bool labels)
{
    const int first = (int)ceil(log10(least));
    const int last = (int)floor(log10(most));
    const int apart = 1 + (last - first) / 6;
    const int steps = last - first < 2 ? 3 : 1; /* within a decade */
    const char *comma = "";
    printf("set %crange [%.4g:%.4g]\nset %ctics (", axis, least, most, axis);
    for (int i = 0; i < steps * (last - first + 2); i++) {
        const int power = first - 1 + i / steps;
        const int times = (int[]){1, 2, 5}[i % steps];
        const double value = times * pow(10, power);
        if (value >= least && value <= most && power % apart == 0) {
            char label[32];
            if (times == 1) {
                snprintf(label, sizeof label, "10^{%d}", power);
            } else {
                snprintf(label, sizeof label, "%de%d", times, power);
            }
            printf("%s'%s' %de%d", comma, labels ? label : "", times, power);
            comma = ", ";
        }
    }
    puts(")");
}
