/* The verdict on one picture, and the terminal's table. */
#include "result.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void describe_pixel(char *text, size_t room, const struct image *image, size_t index)
{
    const uint8_t *rgba = &image->rgba[4 * index];
    const int length = snprintf(text, room, "%d %d %d %d", rgba[0], rgba[1], rgba[2], rgba[3]);
    if (image->depth != NULL)
        snprintf(text + length, room - (size_t)length, " depth %lu", (unsigned long)image->depth[index]);
}

/* Says where the first difference is, in both ways of counting rows, and both pixels' RGBA and depth. */
static void describe_first(struct result *result, const struct image *ours, const struct image *reference)
{
    const int x = result->difference.first_x, y = result->difference.first_y;
    const size_t index = (size_t)y * (size_t)ours->width + (size_t)x;
    char a[64], b[64];
    describe_pixel(a, sizeof a, ours, index);
    describe_pixel(b, sizeof b, reference, index);
    snprintf(result->first, sizeof result->first,
             "x %d, row %d from the top (window y %d): FixedGL %s, reference %s", x, y, ours->height - 1 - y,
             a, b);
}

/* The differing pixels must be exactly as many as the picture's departures account for. */
static void judge(struct result *result, const struct departure_list *departures)
{
    const long differ = result->difference.differ;
    const long expected = fgl_departures_pixels(departures, result->picture->name, &result->departures);
    if (differ == expected) {
        result->verdict = differ == 0 ? VERDICT_IDENTICAL : VERDICT_DEPARTS;
        return;
    }
    result->verdict = VERDICT_DIFFERS;
    if (expected > 0)
        fgl_problem_set(&result->problem,
                        "its departures (%s) account for exactly %ld pixels, but %ld differ",
                        result->departures, expected, differ);
}

static void note_drawn(struct result *result, const struct image *ours)
{
    result->width = ours->width;
    result->height = ours->height;
    result->has_depth = ours->depth != NULL;
}

void fgl_result_compare(struct result *result, const struct image *ours, const struct image *reference,
                        const struct departure_list *departures)
{
    struct problem problem;
    if (ours->renderer[0] != '\0' && strcmp(ours->renderer, reference->renderer) == 0) {
        fgl_problem_set(&problem, "both pictures were drawn by %s", ours->renderer);
        fgl_result_fail(result, &problem);
    } else if (!fgl_compare_images(ours, reference, &result->difference, &problem)) {
        fgl_result_fail(result, &problem);
    } else {
        note_drawn(result, ours);
        if (result->difference.differ > 0)
            describe_first(result, ours, reference);
        judge(result, departures);
    }
}

void fgl_result_undrawn(struct result *result, const struct image *ours, const struct departure *departure)
{
    result->verdict = VERDICT_UNDRAWN;
    note_drawn(result, ours);
    result->departures = fgl_format("%s", departure->name);
}

void fgl_result_fail(struct result *result, const struct problem *problem)
{
    result->verdict = VERDICT_FAILED;
    result->width = result->picture->width;
    result->height = result->picture->height;
    result->difference = (struct difference){0};
    result->problem = *problem;
}

const char *fgl_result_verdict_name(enum verdict verdict)
{
    static const char *const names[] = {"identical", "departs", "undrawn", "differs", "failed"};
    return names[verdict];
}

const char *fgl_result_table_head(void)
{
    return "picture                    size     differ       by 1    by 2-8       more   coverage      depth";
}

static char *format_numbers(const char *name, const char *size, const struct difference *d, bool has_depth)
{
    char coverage[24] = "-", depth[24] = "-";
    if (has_depth) {
        snprintf(coverage, sizeof coverage, "%ld", d->coverage);
        snprintf(depth, sizeof depth, "%ld", d->depth);
    }
    return fgl_format("%-20s %10s %10ld %10ld %9ld %10ld %10s %10s", name, size, d->differ, d->by_1,
                      d->by_2_to_8, d->by_more, coverage, depth);
}

char *fgl_result_line(const struct result *result)
{
    char size[24];
    snprintf(size, sizeof size, "%dx%d", result->width, result->height);
    if (result->verdict == VERDICT_FAILED)
        return fgl_format("%-20s %10s  FAILED: %s", result->picture->name, size, result->problem.text);
    if (result->verdict == VERDICT_UNDRAWN)
        return fgl_format("%-20s %10s  not drawn by the reference: %s", result->picture->name, size,
                          result->departures);
    char *numbers = format_numbers(result->picture->name, size, &result->difference, result->has_depth);
    char *line;
    if (result->verdict == VERDICT_IDENTICAL)
        return numbers;
    if (result->verdict == VERDICT_DEPARTS)
        line = fgl_format("%s\n    named departure: %s", numbers, result->departures);
    else
        line = fgl_format("%s%s%s%s%s", numbers, result->first[0] != '\0' ? "\n    first: " : "",
                          result->first, result->problem.text[0] != '\0' ? "\n    " : "",
                          result->problem.text);
    free(numbers);
    return line;
}

char *fgl_result_summary(const int verdicts[VERDICT_COUNT])
{
    int count = 0;
    for (int i = 0; i < VERDICT_COUNT; i++)
        count += verdicts[i];
    char undrawn[48] = "";
    if (verdicts[VERDICT_UNDRAWN] > 0)
        snprintf(undrawn, sizeof undrawn, ", %d not drawn by the reference", verdicts[VERDICT_UNDRAWN]);
    return fgl_format("%d pictures: %d identical, %d by named departures, %d differ, %d failed%s", count,
                      verdicts[VERDICT_IDENTICAL], verdicts[VERDICT_DEPARTS], verdicts[VERDICT_DIFFERS],
                      verdicts[VERDICT_FAILED], undrawn);
}

int fgl_result_print_totals(const struct result *results, int count)
{
    struct difference sum = {0};
    int verdicts[VERDICT_COUNT] = {0};
    for (int i = 0; i < count; i++) {
        const struct difference *d = &results[i].difference;
        sum.differ += d->differ;
        sum.by_1 += d->by_1;
        sum.by_2_to_8 += d->by_2_to_8;
        sum.by_more += d->by_more;
        sum.coverage += d->coverage;
        sum.depth += d->depth;
        verdicts[results[i].verdict]++;
    }
    char *line = format_numbers("total", "", &sum, true);
    puts(line);
    free(line);
    char *summary = fgl_result_summary(verdicts);
    puts(summary);
    free(summary);
    return verdicts[VERDICT_DIFFERS] + verdicts[VERDICT_FAILED];
}

void fgl_result_free(struct result *result)
{
    free(result->departures);
    result->departures = NULL;
}
