/* fixedgl diff: draws every picture of the list with FixedGL and with the reference, compares, reports. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli.h"
#include "departures.h"
#include "diff_options.h"
#include "draw.h"
#include "goldens.h"
#include "library.h"
#include "pictures.h"
#include "pool.h"
#include "report.h"
#include "result.h"
#include "support.h"

/* Everything one run reads; only `results` is written while the threads work, each item by one of them. */
struct diff {
    struct diff_options options;
    struct picture_list pictures;
    struct departure_list departures;
    struct renderer ours, reference;
    struct library_facts osmesa;
    struct goldens goldens;
    bool from_goldens;
    char *reference_name; /* for people */
    struct result *results;
};

/* A program that has FixedGL linked in statically takes no notice of the preloaded library, and would be
 * compared with itself, or recorded as a golden. So the picture must say that the reference drew it. */
static bool check_drawn_by(const struct image *image, const char *renderer, struct problem *problem)
{
    if (image->renderer[0] == '\0')
        return fgl_problem_set(problem, "reference: its picture does not say which GL_RENDERER drew it");
    return strcmp(image->renderer, renderer) == 0 ||
           fgl_problem_set(problem, "reference: drawn by %s, not by %s", image->renderer, renderer);
}

static bool draw_with_osmesa(const struct diff *diff, const struct picture *picture, struct image *image,
                             struct problem *problem)
{
    if (!fgl_draw_picture(&diff->reference, picture, image, problem))
        return false;
    if (check_drawn_by(image, diff->osmesa.renderer, problem))
        return true;
    fgl_image_free(image);
    return false;
}

static bool get_reference(const struct diff *diff, const struct picture *picture, struct image *image,
                          struct problem *problem)
{
    return diff->from_goldens ? fgl_goldens_load(&diff->goldens, picture, image, problem)
                              : draw_with_osmesa(diff, picture, image, problem);
}

static void compare_with_reference(const struct diff *diff, struct result *result)
{
    struct image ours, reference;
    struct problem problem, ignored;
    const bool drawn = fgl_draw_picture(&diff->ours, result->picture, &ours, &problem);
    const bool known = get_reference(diff, result->picture, &reference, drawn ? &problem : &ignored);
    if (drawn && known)
        fgl_result_compare(result, &ours, &reference, &diff->departures);
    else
        fgl_result_fail(result, &problem);
    if (!fgl_report_write_images(diff->options.output, result->picture, drawn ? &ours : NULL,
                                 known ? &reference : NULL, &problem))
        fgl_result_fail(result, &problem);
    fgl_image_free(&ours);
    fgl_image_free(&reference);
}

/* A picture that the reference cannot draw, which OSMesa must confirm. */
static void draw_alone(const struct diff *diff, const struct departure *undrawn, struct result *result)
{
    struct image ours, reference;
    struct problem problem, refusal;
    bool drawn = fgl_draw_picture(&diff->ours, result->picture, &ours, &problem);
    if (drawn && !diff->from_goldens && draw_with_osmesa(diff, result->picture, &reference, &refusal)) {
        fgl_image_free(&reference);
        drawn = fgl_problem_set(&problem, "the reference draws it, but %s says that it cannot",
                                diff->options.departures);
    }
    if (drawn)
        fgl_result_undrawn(result, &ours, undrawn);
    else
        fgl_result_fail(result, &problem);
    if (!fgl_report_write_images(diff->options.output, result->picture, drawn ? &ours : NULL, NULL, &problem))
        fgl_result_fail(result, &problem);
    fgl_image_free(&ours);
}

static void compare_picture(void *context, int index, char **line)
{
    struct diff *diff = context;
    struct result *result = &diff->results[index];
    result->picture = &diff->pictures.items[index];
    const struct departure *undrawn = fgl_departures_undrawn(&diff->departures, result->picture->name);
    if (undrawn != NULL)
        draw_alone(diff, undrawn, result);
    else
        compare_with_reference(diff, result);
    *line = fgl_result_line(result);
}

static void record_picture(void *context, int index, char **line)
{
    struct diff *diff = context;
    struct result *result = &diff->results[index];
    struct image image;
    struct problem problem;
    result->picture = &diff->pictures.items[index];
    if (fgl_departures_undrawn(&diff->departures, result->picture->name) != NULL) {
        *line = fgl_format("%-20s not drawn by the reference", result->picture->name);
        return;
    }
    if (draw_with_osmesa(diff, result->picture, &image, &problem) &&
        fgl_goldens_write_picture(diff->options.record, result->picture, &image, &diff->osmesa, &problem))
        *line = fgl_format("%-20s recorded, %dx%d, %d bits of depth", result->picture->name, image.width,
                           image.height, image.depth_bits);
    else {
        fgl_result_fail(result, &problem);
        *line = fgl_format("%-20s FAILED: %s", result->picture->name, problem.text);
    }
    fgl_image_free(&image);
}

/* Without FMA the same OSMesa draws other pictures. */
static bool check_fma(struct problem *problem)
{
    return fgl_cpu_has_fma() ||
           fgl_problem_set(problem, "this CPU has no FMA, so OSMesa draws other pictures than elsewhere");
}

static bool use_osmesa(struct diff *diff, struct problem *problem)
{
    struct library_facts *facts = &diff->osmesa;
    if (!fgl_library_query(diff->options.osmesa, facts, problem))
        return false;
    diff->from_goldens = false;
    diff->reference_name = fgl_format("%s, %s, %s", facts->renderer, facts->version,
                                      facts->package[0] != '\0' ? facts->package : facts->path);
    return true;
}

static bool use_goldens(struct diff *diff, struct problem *problem)
{
    struct goldens *goldens = &diff->goldens;
    if (!fgl_goldens_open(diff->options.goldens, goldens, problem))
        return false;
    diff->from_goldens = true;
    diff->reference_name = fgl_format("goldens in %s, recorded from %s, %s, %s", goldens->folder,
                                      goldens->renderer, goldens->version, goldens->package);
    return true;
}

/* Goldens are only recorded, and OSMesa is only chosen unasked, where it draws what it draws everywhere. */
static bool choose_reference(struct diff *diff, struct problem *problem)
{
    const struct diff_options *options = &diff->options;
    if (options->record != NULL)
        return check_fma(problem) && use_osmesa(diff, problem);
    if (options->reference == REFERENCE_OSMESA) {
        if (!check_fma(problem))
            fprintf(stderr, "fixedgl: %s\n", problem->text);
        return use_osmesa(diff, problem);
    }
    if (options->reference == REFERENCE_AUTO) {
        if (check_fma(problem) && use_osmesa(diff, problem))
            return true;
        fprintf(stderr, "fixedgl: comparing with goldens: %s\n", problem->text);
    }
    return use_goldens(diff, problem);
}

/* Programs by path need no list, and no departures are named for them. */
static bool list_pictures(struct diff *diff, struct problem *problem)
{
    const struct diff_options *options = &diff->options;
    if (options->by_path)
        return fgl_pictures_of_programs(options->names, options->name_count, options->events ? options->events : "",
                                        &diff->pictures, problem);
    return fgl_pictures_read(options->pictures, &diff->pictures, problem) &&
           fgl_departures_read(options->departures, &diff->pictures, &diff->departures, problem);
}

static bool prepare(struct diff *diff, char **scratch, struct problem *problem)
{
    const struct diff_options *options = &diff->options;
    if (!list_pictures(diff, problem) || !choose_reference(diff, problem))
        return false;
    if (options->name_count > 0 && !options->by_path &&
        !fgl_pictures_select(&diff->pictures, options->names, options->name_count, problem))
        return false;
    *scratch = fgl_format("%s/scratch", options->output);
    if (!fgl_make_folder(*scratch, problem) ||
        (options->record != NULL && !fgl_make_folder(options->record, problem)))
        return false;
    diff->ours = (struct renderer){"FixedGL", "fixedgl", NULL, options->programs, *scratch, options->timeout};
    diff->reference = (struct renderer){"reference",       "reference", options->osmesa,
                                        options->programs, *scratch,    options->timeout};
    diff->results = fgl_allocate((size_t)diff->pictures.count, sizeof *diff->results);
    return true;
}

static int compare_all(struct diff *diff)
{
    struct problem problem;
    printf("reference: %s\n%s\n", diff->reference_name, fgl_result_table_head());
    fgl_pool_run(diff->pictures.count, diff->options.jobs, compare_picture, diff);
    const int bad = fgl_result_print_totals(diff->results, diff->pictures.count);
    if (!fgl_report_write(diff->options.output, diff->reference_name, diff->results, diff->pictures.count,
                          &problem))
        return fgl_complain("%s", problem.text);
    printf("report: %s/index.html\n", diff->options.output);
    return bad == 0 ? EXIT_SAME : EXIT_DIFFERS;
}

static int record_all(struct diff *diff)
{
    struct problem problem;
    int failed = 0, recorded = 0;
    printf("recording from %s\n", diff->reference_name);
    fgl_pool_run(diff->pictures.count, diff->options.jobs, record_picture, diff);
    for (int i = 0; i < diff->pictures.count; i++)
        failed += diff->results[i].verdict == VERDICT_FAILED;
    if (failed > 0) {
        fgl_complain("%d of %d pictures could not be recorded; GOLDENS.txt is not written", failed,
                     diff->pictures.count);
        return EXIT_DIFFERS;
    }
    if (!fgl_goldens_write_index(diff->options.record, &diff->pictures, &diff->departures, &diff->osmesa,
                                 &recorded, &problem))
        return fgl_complain("%s", problem.text);
    printf("%d goldens in %s\n", recorded, diff->options.record);
    return EXIT_SAME;
}

static void free_diff(struct diff *diff)
{
    for (int i = 0; diff->results != NULL && i < diff->pictures.count; i++)
        fgl_result_free(&diff->results[i]);
    free(diff->results);
    free(diff->reference_name);
    fgl_goldens_close(&diff->goldens);
    fgl_departures_free(&diff->departures);
    fgl_pictures_free(&diff->pictures);
}

int fgl_cli_diff(int argc, char **argv)
{
    struct diff diff = {0};
    struct problem problem;
    char *scratch = NULL;
    int code;
    if (!fgl_diff_options_read(argc, argv, &diff.options, &code))
        return code;
    if (!prepare(&diff, &scratch, &problem))
        code = fgl_complain("%s", problem.text);
    else
        code = diff.options.record != NULL ? record_all(&diff) : compare_all(&diff);
    if (scratch != NULL)
        remove(scratch);
    free(scratch);
    free_diff(&diff);
    return code;
}
