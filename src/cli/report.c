/* The page of the report. */
#define _POSIX_C_SOURCE 200809L
#include "report.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "report_page.h"

static void put_paragraph(FILE *page, const char *before, const char *text, const char *after)
{
    if (text == NULL || text[0] == '\0')
        return;
    fprintf(page, "<p>%s", before);
    fgl_put_escaped(page, text);
    fprintf(page, "%s</p>\n", after);
}

static bool exists(const char *folder, const char *name, const char *kind)
{
    char *path = fgl_format("%s/%s.%s.png", folder, name, kind);
    const bool found = access(path, F_OK) == 0;
    free(path);
    return found;
}

/* One picture with its caption. `shown` is the file in the thumbnail, `whole` what a click enlarges. */
static void put_figure(FILE *page, const char *folder, const char *name, const char *shown, const char *whole,
                       const char *caption, const char *instead)
{
    fputs("<figure>", page);
    if (exists(folder, name, shown))
        fprintf(page,
                "<a href=\"%s.%s.png\" data-label=\"%s: %s\">"
                "<img class=\"%s\" src=\"%s.%s.png\" alt=\"%s\"></a>",
                name, whole, name, caption, shown, name, shown, caption);
    else
        fprintf(page, "<span>%s</span>", instead);
    fprintf(page, "<figcaption>%s</figcaption></figure>\n", caption);
}

static void put_numbers(FILE *page, const struct result *result)
{
    const struct difference *d = &result->difference;
    fprintf(page, "<table><tr><th>pixels differing<th>by 1<th>by 2&ndash;8<th>by more<th>largest<th>coverage"
                  "<th>depth values<th>largest</tr>\n");
    fprintf(page, "<tr><td>%ld of %ld<td>%ld<td>%ld<td>%ld<td>%d", d->differ, d->pixels, d->by_1,
            d->by_2_to_8, d->by_more, d->largest_channel);
    if (result->has_depth)
        fprintf(page, "<td>%ld<td>%ld<td>%lu</tr></table>\n", d->coverage, d->depth,
                (unsigned long)d->largest_depth);
    else
        fprintf(page, "<td>&ndash;<td>no depth buffer<td>&ndash;</tr></table>\n");
}

static void put_heading(FILE *page, const struct result *result)
{
    const struct picture *picture = result->picture;
    const char *verdict = fgl_result_verdict_name(result->verdict);
    fprintf(page, "<section class=\"%s\" id=\"%s\">\n<h2>%s</h2><span class=\"verdict\">%s</span>", verdict,
            picture->name, picture->name, verdict);
    fprintf(page, "<span class=\"soft\">%d&times;%d, ", result->width, result->height);
    fgl_put_escaped(page, picture->program);
    if (picture->events[0] != '\0') {
        fputs(" after <code>", page);
        fgl_put_escaped(page, picture->events);
        fputs("</code>", page);
    }
    fputs("</span>\n", page);
}

static void put_figures(FILE *page, const char *folder, const struct result *result)
{
    const struct picture *picture = result->picture;
    const bool same = result->verdict == VERDICT_IDENTICAL;
    if (!exists(folder, picture->name, "fixedgl") && !exists(folder, picture->name, "reference"))
        return;
    fputs("<div class=\"row\">\n", page);
    put_figure(page, folder, picture->name, "fixedgl", "fixedgl", "FixedGL", "not drawn");
    put_figure(page, folder, picture->name, "reference", "reference", "reference", "not drawn");
    put_figure(page, folder, picture->name, "map", "difference", "difference, amplified",
               same ? "no difference" : "not compared");
    fputs("</div>\n", page);
}

static void put_result(FILE *page, const char *folder, const struct result *result)
{
    put_heading(page, result);
    put_figures(page, folder, result);
    if (result->verdict != VERDICT_FAILED && result->verdict != VERDICT_UNDRAWN)
        put_numbers(page, result);
    put_paragraph(page, "<span class=\"soft\">named departures:</span> ", result->departures, "");
    put_paragraph(page, "", result->problem.text, "");
    put_paragraph(page, "<span class=\"soft\">first differing pixel (RGBA):</span> <code>", result->first,
                  "</code>");
    fputs("</section>\n", page);
}

static void put_summary(FILE *page, const char *reference_name, const struct result *results, int count)
{
    int verdicts[VERDICT_COUNT] = {0};
    for (int i = 0; i < count; i++)
        verdicts[results[i].verdict]++;
    fprintf(page, "<h1>FixedGL and its reference, pixel by pixel</h1>\n");
    char *summary = fgl_result_summary(verdicts);
    fprintf(page, "<p>%s.</p>\n", summary);
    free(summary);
    put_paragraph(page, "<span class=\"soft\">Reference:</span> ", reference_name, "");
    fputs("<p class=\"soft\">In the difference pictures each pixel has the color of its kind, over a dim "
          "copy of"
          " the reference:<i class=\"key\" style=\"background:#ff50ff\"></i>coverage (drawn on one side only)"
          "<i class=\"key\" style=\"background:#ff4030\"></i>by more than 8"
          "<i class=\"key\" style=\"background:#ffc400\"></i>by 2&ndash;8"
          "<i class=\"key\" style=\"background:#00c878\"></i>by 1"
          "<i class=\"key\" style=\"background:#4285f4\"></i>depth alone. The small ones show the worst "
          "pixel of"
          " each square.</p>\n",
          page);
}

/* Failed first, then by how visibly the pictures differ; equal ones in the order of the list. */
static int compare_results(const void *left, const void *right)
{
    const struct result *a = *(const struct result *const *)left, *b = *(const struct result *const *)right;
    const long keys[][2] = {
            {a->verdict, b->verdict},
            {a->difference.by_more + a->difference.coverage, b->difference.by_more + b->difference.coverage},
            {a->difference.by_2_to_8, b->difference.by_2_to_8},
            {a->difference.differ, b->difference.differ},
    };
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
        if (keys[i][0] != keys[i][1])
            return keys[i][0] > keys[i][1] ? -1 : 1;
    return (a->picture > b->picture) - (a->picture < b->picture);
}

bool fgl_report_write(const char *folder, const char *reference_name, const struct result *results, int count,
                      struct problem *problem)
{
    char *path = fgl_format("%s/index.html", folder);
    FILE *page = fopen(path, "w");
    bool good = page != NULL;
    if (good) {
        const struct result **sorted = fgl_allocate((size_t)count, sizeof *sorted);
        for (int i = 0; i < count; i++)
            sorted[i] = &results[i];
        qsort(sorted, (size_t)count, sizeof *sorted, compare_results);
        fputs(fgl_report_page_head, page);
        put_summary(page, reference_name, results, count);
        for (int i = 0; i < count; i++)
            put_result(page, folder, sorted[i]);
        fputs(fgl_report_page_foot, page);
        free(sorted);
        good = !ferror(page);
        good = fclose(page) == 0 && good;
    }
    if (!good)
        fgl_problem_set(problem, "%s: %s", path, strerror(errno));
    free(path);
    return good;
}
