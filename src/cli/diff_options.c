/* The command line of `fixedgl diff`. */
#define _POSIX_C_SOURCE 200809L
#include "diff_options.h"

#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char usage[] =
        "usage: fixedgl diff [OPTION...] [PICTURE...]\n"
        "       fixedgl diff [OPTION...] [--events SCRIPT] PATH/PROGRAM...\n"
        "\n"
        "Draws the pictures of a list with FixedGL and with Mesa's OSMesa, compares every byte of colour "
        "and\n"
        "every depth value, and writes a report. Without names, all pictures of the list.\n"
        "The second form draws programs of your own, in their own size, and needs OSMesa.\n"
        "\n"
        "  --pictures FILE      the picture list             (examples/pictures.txt)\n"
        "  --examples DIR       the example programs         (build/examples)\n"
        "  --departures FILE    the named departures         (tests/departures.txt)\n"
        "  --goldens DIR        the recorded goldens         (tests/goldens)\n"
        "  --output DIR         the report, DIR/index.html   (build/diff)\n"
        "  --osmesa LIBRARY     the reference library        (libOSMesa.so.8)\n"
        "  --reference WHICH    osmesa, goldens, or auto: OSMesa where it can be loaded and the CPU has "
        "FMA,\n"
        "                       else the goldens             (auto)\n"
        "  --events SCRIPT      input for programs of your own, as in FIXEDGL_EVENTS\n"
        "  --record DIR         record goldens from OSMesa into DIR instead of comparing\n"
        "  --jobs N             pictures drawn at once       (2)\n"
        "  --timeout SECONDS    for one program              (60)\n"
        "\n"
        "Exit status: 0 if nothing differs but by named departures, 1 if something differs or fails, 2 if "
        "it\n"
        "could not start.\n";

static bool read_number(const char *text, double least, double most, double *value)
{
    char *end;
    *value = strtod(text, &end);
    return end != text && *end == '\0' && *value >= least && *value <= most;
}

static bool read_reference(const char *text, enum reference_choice *choice)
{
    static const char *const names[] = {"auto", "osmesa", "goldens"};
    for (int i = 0; i < 3; i++) {
        if (strcmp(text, names[i]) == 0) {
            *choice = (enum reference_choice)i;
            return true;
        }
    }
    return false;
}

/* Stores the value of one option. False if the value is not one it can have. */
static bool store(struct diff_options *options, int option, const char *value)
{
    double number = 0;
    switch (option) {
    case 'p': options->pictures = value; return true;
    case 'e': options->programs = value; return true;
    case 'd': options->departures = value; return true;
    case 'g': options->goldens = value; return true;
    case 'o': options->output = value; return true;
    case 'm': options->osmesa = value; return true;
    case 'v': options->events = value; return true;
    case 'w': options->record = value; return true;
    case 'r': return read_reference(value, &options->reference);
    case 't': return read_number(value, 0.01, 1e6, &options->timeout);
    default:
        if (!read_number(value, 1, 64, &number) || number != (int)number)
            return false;
        options->jobs = (int)number;
        return true;
    }
}

bool fgl_diff_options_read(int argc, char **argv, struct diff_options *options, int *exit_code)
{
    static const struct option table[] = {
            {"pictures", required_argument, NULL, 'p'},
            {"examples", required_argument, NULL, 'e'},
            {"departures", required_argument, NULL, 'd'},
            {"goldens", required_argument, NULL, 'g'},
            {"output", required_argument, NULL, 'o'},
            {"osmesa", required_argument, NULL, 'm'},
            {"reference", required_argument, NULL, 'r'},
            {"events", required_argument, NULL, 'v'},
            {"record", required_argument, NULL, 'w'},
            {"jobs", required_argument, NULL, 'j'},
            {"timeout", required_argument, NULL, 't'},
            {"help", no_argument, NULL, 'h'},
            {NULL, 0, NULL, 0},
    };
    *options = (struct diff_options){
            .pictures = "examples/pictures.txt",
            .programs = "build/examples",
            .departures = "tests/departures.txt",
            .osmesa = "libOSMesa.so.8",
            .goldens = "tests/goldens",
            .output = "build/diff",
            .jobs = 2,
            .timeout = 60,
    };
    *exit_code = EXIT_USAGE;
    opterr = 0;
    for (int option, which = 0; (option = getopt_long(argc, argv, "", table, &which)) != -1;) {
        if (option == 'h') {
            fputs(usage, stdout);
            *exit_code = EXIT_SAME;
            return false;
        }
        if (option == '?')
            return fgl_complain("diff: `%s` is not an option or lacks its value", argv[optind - 1]) ==
                   EXIT_SAME;
        if (!store(options, option, optarg))
            return fgl_complain("diff: --%s cannot be '%s'", table[which].name, optarg) == EXIT_SAME;
    }
    options->names = argv + optind;
    options->name_count = argc - optind;
    if (options->record != NULL && options->name_count > 0)
        return fgl_complain("diff: --record records the whole list and takes no names") == EXIT_SAME;
    options->by_path = options->name_count > 0 && strchr(options->names[0], '/') != NULL;
    if (options->events != NULL && !options->by_path)
        return fgl_complain("diff: --events is for programs that are given by path") == EXIT_SAME;
    if (options->by_path)
        options->reference = REFERENCE_OSMESA;
    return true;
}
