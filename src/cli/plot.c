/* Plots as inline SVG. Lengths are in pixels of the SVG's own coordinate system. */
#include "plot.h"

#include "support.h"

#include <math.h>

enum { WIDTH = 620, HEIGHT = 300, LEFT = 58, RIGHT = 12, TOP = 10, BOTTOM = 40 };

/* 0 at the low end, 1 at the high one. */
static double position(const struct plot_axis *axis, double value)
{
    value = fmin(fmax(value, axis->low), axis->high);
    if (axis->logarithmic)
        return log(value / axis->low) / log(axis->high / axis->low);
    return (value - axis->low) / (axis->high - axis->low);
}

static double x_of(const struct plot_axis *axis, double value)
{
    return LEFT + (WIDTH - LEFT - RIGHT) * position(axis, value);
}

static double y_of(const struct plot_axis *axis, double value)
{
    return HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * position(axis, value);
}

/* From one mark to the next: so many decades that there are at most eight; or a power of two of the range. */
static double step_of(const struct plot_axis *axis)
{
    if (!axis->logarithmic)
        return (axis->high - axis->low) / 8;
    return ceil(log10(axis->high / axis->low) / 8 - 1e-9);
}

static void write_mark(FILE *page, const struct plot_axis *axis, double value, bool vertical)
{
    char text[32];
    const double ten = axis->logarithmic ? round(log10(value)) : 0;
    if (axis->logarithmic && fabs(ten) > 2)
        snprintf(text, sizeof text, "1e%.0f", ten);
    else
        snprintf(text, sizeof text, "%g", value);
    if (vertical)
        fprintf(page,
                "<line class=\"grid\" x1=\"%d\" x2=\"%d\" y1=\"%.1f\" y2=\"%.1f\"/>"
                "<text class=\"y\" x=\"%d\" y=\"%.1f\">%s</text>\n",
                LEFT, WIDTH - RIGHT, y_of(axis, value), y_of(axis, value), LEFT - 6, y_of(axis, value) + 4,
                text);
    else
        fprintf(page,
                "<line class=\"grid\" x1=\"%.1f\" x2=\"%.1f\" y1=\"%d\" y2=\"%d\"/>"
                "<text class=\"x\" x=\"%.1f\" y=\"%d\">%s</text>\n",
                x_of(axis, value), x_of(axis, value), TOP, HEIGHT - BOTTOM, x_of(axis, value),
                HEIGHT - BOTTOM + 16, text);
}

static void write_axis(FILE *page, const struct plot_axis *axis, bool vertical)
{
    const double step = step_of(axis);
    if (axis->logarithmic) {
        const double first = ceil(log10(axis->low) / step - 1e-9) * step;
        for (double ten = first; ten <= log10(axis->high) + 1e-9; ten += step)
            write_mark(page, axis, pow(10, ten), vertical);
    } else {
        for (int i = 0; i <= 8; i++)
            write_mark(page, axis, axis->low + i * step, vertical);
    }
    if (vertical)
        fprintf(page, "<text class=\"title\" transform=\"translate(13 %d) rotate(-90)\">",
                (TOP + HEIGHT - BOTTOM) / 2);
    else
        fprintf(page, "<text class=\"title\" x=\"%d\" y=\"%d\">", (LEFT + WIDTH - RIGHT) / 2, HEIGHT - 6);
    fgl_put_escaped(page, axis->title);
    fputs("</text>\n", page);
}

static void write_series(FILE *page, const struct plot_axis *x, const struct plot_axis *y,
                         const struct plot_series *s)
{
    if (s->line) {
        fprintf(page, "<polyline fill=\"none\" stroke=\"%s\" stroke-width=\"1.8\" points=\"", s->color);
        for (int i = 0; i < s->count; i++)
            fprintf(page, "%.1f,%.1f ", x_of(x, s->x[i]), y_of(y, s->y[i]));
        fputs("\"/>\n", page);
        return;
    }
    for (int i = 0; i < s->count; i++) {
        fprintf(page, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3.5\" fill=\"%s\" fill-opacity=\".6\"><title>%s",
                x_of(x, s->x[i]), y_of(y, s->y[i]), s->color, s->name);
        if (s->label != NULL) {
            fputs(", ", page);
            fgl_put_escaped(page, s->label[i]);
        }
        fprintf(page, ": %.3g, %.2e</title></circle>\n", s->x[i], s->y[i]);
    }
}

void fgl_plot_write(FILE *page, const struct plot_axis *x, const struct plot_axis *y,
                    const struct plot_series *series, int count)
{
    fprintf(page, "<svg viewBox=\"0 0 %d %d\" role=\"img\">\n", WIDTH, HEIGHT);
    write_axis(page, x, false);
    write_axis(page, y, true);
    for (int i = 0; i < count; i++)
        write_series(page, x, y, &series[i]);
    fputs("</svg>\n", page);
}
