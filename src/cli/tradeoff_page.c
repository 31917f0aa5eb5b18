/* The page of `fixedgl tradeoff`. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plot.h"
#include "tradeoff.h"

static const char head[] =
        "<!DOCTYPE html>\n"
        "<html lang=\"en\">\n"
        "<head>\n"
        "<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width\">\n"
        "<title>fixedgl tradeoff</title>\n"
        "<style>\n"
        ":root { color-scheme: light dark; --ground: #fff; --text: #1c1e21; --soft: #666c74; --line: "
        "#e3e5e9; }\n"
        "@media (prefers-color-scheme: dark) {\n"
        "  :root { --ground: #16181b; --text: #e4e6e9; --soft: #959ba3; --line: #2b2f34; } }\n"
        "body { margin: 0 auto; max-width: 80rem; padding: 1.5rem; background: var(--ground);\n"
        "  color: var(--text); font: 15px/1.5 system-ui, sans-serif; }\n"
        "h1 { font-size: 1.5rem; margin: 0; }\n"
        "h2 { font-size: 1.15rem; margin: 2rem 0 .3rem; }\n"
        "h3 { font-size: .95rem; font-weight: 600; margin: 0; }\n"
        "p { margin: .3rem 0; max-width: 60rem; }\n"
        ".soft { color: var(--soft); }\n"
        ".key { margin-right: 1.2em; }\n"
        ".key::before { content: ''; display: inline-block; width: .8em; height: .8em; border-radius: 50%;\n"
        "  margin-right: .4em; background: var(--color); }\n"
        ".plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(30rem, 1fr)); gap: 1.2rem; "
        "}\n"
        "svg { width: 100%; height: auto; }\n"
        "svg text { fill: var(--soft); font-size: 11px; }\n"
        "svg .x, svg .title { text-anchor: middle; }\n"
        "svg .y { text-anchor: end; }\n"
        "svg .grid { stroke: var(--line); }\n"
        "table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: .85rem; }\n"
        "td, th { text-align: right; padding: .1rem .9rem .1rem 0; font-weight: normal; }\n"
        "th { color: var(--soft); }\n"
        "td:first-child, th:first-child, td.who { text-align: left; }\n"
        "tr.first td { border-top: 1px solid var(--line); }\n"
        "td.bad { color: #d33a2c; font-weight: 600; }\n"
        ".spheres td { text-align: center; padding: .2rem .5rem; }\n"
        ".spheres td:first-child { text-align: left; max-width: 14rem; }\n"
        ".spheres th { text-align: center; }\n"
        ".spheres img { display: block; width: 120px; height: 120px; }\n"
        "</style>\n"
        "</head>\n"
        "<body>\n";

static const struct plot_axis error_axis = {"greatest error", 1e-9, 1, true};
static const double byte_step = 1.0 / 255;

static bool takes_part(const struct tradeoff *t, int renderer, enum tradeoff_kind kind)
{
    for (int i = 0; i < t->count; i++)
        if (t->jobs[i].kind == kind && t->jobs[i].result[renderer].count > 0)
            return true;
    return false;
}

static int count_of(const struct tradeoff *t, enum tradeoff_kind kind)
{
    int count = 0;
    for (int i = 0; i < t->count; i++)
        count += t->jobs[i].kind == kind;
    return count;
}

static void put_key(FILE *page, const struct tradeoff *t, enum tradeoff_kind kind)
{
    fputs("<p>", page);
    for (int r = 0; r < MEASURED_RENDERERS; r++)
        if (takes_part(t, r, kind))
            fprintf(page, "<span class=\"key\" style=\"--color:%s\">%s</span>",
                    fgl_tradeoff_renderers[r].color, fgl_tradeoff_renderers[r].name);
    fputs("</p>\n", page);
}

/* ---- the summary ---- */

static void put_summary(FILE *page, const struct tradeoff *t, enum tradeoff_kind kind, const char *title)
{
    if (count_of(t, kind) == 0)
        return;
    fprintf(page,
            "<h2>%s: %d categories</h2>\n<table><tr><th>renderer<th>categories wrong by more than 1/255"
            "<th>8-bit values wrong<th>NaN or out of range<th>ns per %s, median",
            title, count_of(t, kind), kind == LIGHTING ? "vertex" : "triangle");
    if (kind == TRIANGLES)
        fputs("<th>pixels of wrong coverage<th>greatest error of depth, 2<sup>-24</sup>", page);
    fputs("</tr>\n", page);
    for (int r = 0; r < MEASURED_RENDERERS; r++) {
        const struct tradeoff_summary s = fgl_tradeoff_summarize(t, kind, r);
        if (s.categories == 0)
            continue;
        fprintf(page, "<tr><td>%s<td%s>%d<td>%ld<td>%ld<td>%.1f", fgl_tradeoff_renderers[r].name,
                s.wrong > 0 ? " class=\"bad\"" : "", s.wrong, s.bytes, s.invalid, s.ns);
        if (kind == TRIANGLES)
            fprintf(page, "<td>%ld<td>%.1f", s.coverage + s.corners, s.depth);
        fputs("</tr>\n", page);
    }
    fputs("</table>\n", page);
}

/* ---- speed against error: a dot for each category and renderer ---- */

static void put_scatter(FILE *page, const struct tradeoff *t, enum tradeoff_kind kind,
                        const struct plot_axis *x, const struct plot_axis *y,
                        double (*value)(const struct tradeoff_figures *))
{
    struct plot_series series[MEASURED_RENDERERS];
    const size_t room = (size_t)t->count;
    double *xs = fgl_allocate(room * MEASURED_RENDERERS, sizeof *xs),
           *ys = fgl_allocate(room * MEASURED_RENDERERS, sizeof *ys);
    const char **labels = fgl_allocate(room * MEASURED_RENDERERS, sizeof *labels);
    size_t used = 0;
    for (int r = 0; r < MEASURED_RENDERERS; r++) {
        series[r] = (struct plot_series){fgl_tradeoff_renderers[r].name,
                                         fgl_tradeoff_renderers[r].color,
                                         false,
                                         0,
                                         xs + used,
                                         ys + used,
                                         labels + used};
        for (int i = 0; i < t->count; i++) {
            if (t->jobs[i].kind != kind || t->jobs[i].result[r].count == 0)
                continue;
            xs[used] = t->jobs[i].result[r].figures->ns;
            ys[used] = value(t->jobs[i].result[r].figures);
            labels[used++] = t->jobs[i].name;
            series[r].count++;
        }
    }
    fgl_plot_write(page, x, y, series, MEASURED_RENDERERS);
    free(xs), free(ys), free(labels);
}

static double greatest_error(const struct tradeoff_figures *f)
{
    return f->max;
}

static double greatest_depth_error(const struct tradeoff_figures *f)
{
    return f->depth_max;
}

static void put_scatters(FILE *page, const struct tradeoff *t)
{
    const struct plot_axis vertex = {"ns per vertex", 3, 1000, true},
                           triangle = {"ns per triangle", 100, 100000, true},
                           depth = {"greatest error of depth, units of 1/16777216", 0.1, 1e5, true};
    fputs("<h2>Speed against error</h2>\n<p class=\"soft\">A dot for each category; the pointer shows which. "
          "Cheaper is left, "
          "more accurate is down. An error of 1/255, one step of a byte, is 3.9e-3; one of 1e-9 or less is "
          "drawn at the "
          "bottom.</p>\n",
          page);
    put_key(page, t, LIGHTING);
    fputs("<div class=\"plots\">\n", page);
    if (count_of(t, LIGHTING) > 0) {
        fputs("<div><h3>Lit vertices</h3>\n", page);
        put_scatter(page, t, LIGHTING, &vertex, &error_axis, greatest_error);
        fputs("</div>\n", page);
    }
    if (count_of(t, TRIANGLES) > 0) {
        fputs("<div><h3>Triangles: color</h3>\n", page);
        put_scatter(page, t, TRIANGLES, &triangle, &error_axis, greatest_error);
        fputs("</div>\n<div><h3>Triangles: depth</h3>\n", page);
        put_scatter(page, t, TRIANGLES, &triangle, &depth, greatest_depth_error);
        fputs("</div>\n", page);
    }
    fputs("</div>\n", page);
}

/* ---- sweeps ---- */

static void put_sweep(FILE *page, const struct tradeoff_job *job)
{
    struct plot_series series[MEASURED_RENDERERS];
    struct plot_axis x = {job->name, 0, 1, job->logarithmic};
    double *values[MEASURED_RENDERERS];
    for (int r = 0; r < MEASURED_RENDERERS; r++) {
        const struct tradeoff_result *result = &job->result[r];
        const int n = result->count;
        values[r] = fgl_allocate(2 * (size_t)n + 1, sizeof **values);
        for (int i = 0; i < n; i++) {
            values[r][i] = result->figures[i].at;
            values[r][n + i] = result->figures[i].max;
        }
        if (n > 1) {
            x.low = result->figures[0].at;
            x.high = result->figures[n - 1].at;
        }
        series[r] = (struct plot_series){fgl_tradeoff_renderers[r].name,
                                         fgl_tradeoff_renderers[r].color,
                                         true,
                                         n,
                                         values[r],
                                         values[r] + n,
                                         NULL};
    }
    fgl_plot_write(page, &x, &error_axis, series, MEASURED_RENDERERS);
    for (int r = 0; r < MEASURED_RENDERERS; r++)
        free(values[r]);
}

static void put_sweeps(FILE *page, const struct tradeoff *t)
{
    if (count_of(t, SWEEP) == 0)
        return;
    fputs("<h2>From one extreme to the other</h2>\n<p class=\"soft\">The greatest error over the vertices at "
          "each "
          "point.</p>\n",
          page);
    put_key(page, t, SWEEP);
    fputs("<div class=\"plots\">\n", page);
    for (int i = 0; i < t->count; i++) {
        if (t->jobs[i].kind != SWEEP)
            continue;
        fputs("<div><h3>", page);
        fgl_put_escaped(page, t->jobs[i].name);
        fputs("</h3>\n", page);
        put_sweep(page, &t->jobs[i]);
        fputs("</div>\n", page);
    }
    fputs("</div>\n", page);
}

/* ---- spheres ---- */

static void put_spheres(FILE *page, const struct tradeoff *t)
{
    static const int order[RENDERERS] = {TRUTH, OSMESA, PLAIN, COMPATIBLE, EXACT};
    if (count_of(t, SPHERE) == 0)
        return;
    fputs("<h2>What extremes do to a sphere</h2>\n<p class=\"soft\">Each pixel is a lit vertex. The extremes "
          "change the "
          "numbers of the scene, and most leave its picture as it was. Magenta: a color that is no "
          "number.</p>\n"
          "<table class=\"spheres\"><tr><th>",
          page);
    for (int k = 0; k < RENDERERS; k++)
        if (takes_part(t, order[k], SPHERE))
            fprintf(page, "<th>%s", fgl_tradeoff_renderers[order[k]].name);
    fputs("</tr>\n", page);
    for (int i = 0; i < t->count; i++) {
        if (t->jobs[i].kind != SPHERE)
            continue;
        fputs("<tr><td>", page);
        fgl_put_escaped(page, t->jobs[i].name);
        for (int k = 0; k < RENDERERS; k++) {
            if (!takes_part(t, order[k], SPHERE))
                continue;
            char *picture = fgl_tradeoff_picture(t, &t->jobs[i], order[k]);
            fprintf(page, "<td><img src=\"%s\" alt=\"%s\">", picture, fgl_tradeoff_renderers[order[k]].name);
            free(picture);
        }
        fputs("</tr>\n", page);
    }
    fputs("</table>\n", page);
}

/* ---- all figures ---- */

static void put_row(FILE *page, const struct tradeoff_job *job, int renderer, bool first)
{
    const struct tradeoff_figures *f = job->result[renderer].figures;
    fprintf(page, "<tr%s><td>", first ? " class=\"first\"" : "");
    if (first)
        fgl_put_escaped(page, job->name);
    fprintf(page, "<td class=\"who\">%s<td%s>%.1e<td>%.1e<td>%.1e<td>%ld<td>%ld<td>%.1f",
            fgl_tradeoff_renderers[renderer].name, f->max > byte_step ? " class=\"bad\"" : "", f->max,
            f->p999, f->mean, f->bytes, f->invalid, f->ns);
    if (job->kind == TRIANGLES)
        fprintf(page, "<td>%.1f<td>%.1f<td>%.1f<td>%ld", f->depth_max, f->depth_p999, f->depth_mean,
                f->coverage + f->corners);
    fputs("</tr>\n", page);
}

static void put_table(FILE *page, const struct tradeoff *t, enum tradeoff_kind kind, const char *title)
{
    if (count_of(t, kind) == 0)
        return;
    fprintf(page,
            "<h2>%s</h2>\n<table><tr><th>category<th class=\"who\">renderer<th>greatest error<th>99.9 "
            "%%<th>mean"
            "<th>bytes wrong<th>NaN<th>ns%s</tr>\n",
            title, kind == TRIANGLES ? "<th>depth: greatest<th>99.9 %<th>mean<th>coverage" : "");
    for (int i = 0; i < t->count; i++) {
        bool first = true;
        for (int r = 0; r < MEASURED_RENDERERS && t->jobs[i].kind == kind; r++) {
            if (t->jobs[i].result[r].count == 0)
                continue;
            put_row(page, &t->jobs[i], r, first);
            first = false;
        }
    }
    fputs("</table>\n", page);
}

bool fgl_tradeoff_write_page(const struct tradeoff *t, struct problem *problem)
{
    char *path = fgl_format("%s/index.html", t->output);
    FILE *page = fopen(path, "w");
    if (page == NULL) {
        fgl_problem_set(problem, "%s: %s", path, strerror(errno));
        free(path);
        return false;
    }
    fputs(head, page);
    fputs("<h1>Speed against accuracy</h1>\n<p class=\"soft\">", page);
    fgl_put_escaped(page, t->gl_renderer[1]);
    fputs("; ", page);
    fgl_put_escaped(page, t->osmesa != NULL ? t->gl_renderer[0] : "OSMesa is not installed");
    fprintf(page, "; seed %s, %d vertices per category; the truth is computed in 113 bits</p>\n", t->seed,
            t->vertices);
    put_summary(page, t, LIGHTING, "Lit vertices");
    put_summary(page, t, TRIANGLES, "Triangles");
    put_scatters(page, t);
    put_sweeps(page, t);
    put_spheres(page, t);
    put_table(page, t, LIGHTING, "Lit vertices, all figures");
    put_table(page, t, TRIANGLES, "Triangles, all figures");
    fputs("</body>\n</html>\n", page);
    const bool good = fclose(page) == 0 || fgl_problem_set(problem, "%s: %s", path, strerror(errno));
    free(path);
    return good;
}
