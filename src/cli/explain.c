/* fixedgl explain. */
#define _POSIX_C_SOURCE 200809L
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli.h"
#include "run.h"
#include "support.h"

static const char usage[] = "usage: fixedgl explain PROGRAM --pixel X,Y [OPTION...] [-- ARGUMENT...]\n"
                            "\n"
                            "Runs a program that is linked with libfixedglut, headless, and prints why a "
                            "pixel of its last picture\n"
                            "has its colour: the primitive, its vertices, each term of the lighting "
                            "equation, the fragment stages.\n"
                            "\n"
                            "  --pixel X,Y          the pixel, from the lower left, as glReadPixels\n"
                            "  --vertex N           only vertex N of the primitive: 0, 1 or 2\n"
                            "  --json               as JSON (docs/explain.md lists its members)\n"
                            "  --frame N            the Nth frame                (1)\n"
                            "  --events SCRIPT      input after that, in the form of FIXEDGL_EVENTS\n"
                            "  --size WxH           the window's size\n"
                            "  --timeout SECONDS    for the program              (60)\n"
                            "\n"
                            "Exit status: 0 if the pixel was explained, 2 if not.\n";

/* Reads "X,Y" or "N" and nothing after it. */
static bool read_numbers(const char *text, int n, int least, int most, int *number)
{
    for (int i = 0; i < n; i++) {
        char *end;
        const long value = strtol(text, &end, 10);
        if (end == text || *end != (i + 1 < n ? ',' : '\0') || value < least || value > most)
            return false;
        number[i] = (int)value;
        text = end + 1;
    }
    return true;
}

static const struct option options[] = {
        {"pixel", required_argument, NULL, 'p'},
        {"vertex", required_argument, NULL, 'v'},
        {"json", no_argument, NULL, 'j'},
        {"frame", required_argument, NULL, 'f'},
        {"events", required_argument, NULL, 'e'},
        {"size", required_argument, NULL, 's'},
        {"timeout", required_argument, NULL, 't'},
        {"help", no_argument, NULL, 'h'},
        {NULL, 0, NULL, 0},
};

static int explain(struct run *run, const int pixel[2], int vertex)
{
    struct problem problem;
    char *variable = fgl_format("FIXEDGL_EXPLAIN=%d,%d,%d", pixel[0], pixel[1], vertex);
    run->set[0] = variable;
    run->set[1] = "FIXEDGL_EXPLAIN_OUT=";
    char *text = fgl_run(run, &problem);
    free(variable);
    if (!text)
        return fgl_complain("explain: %s", problem.text);
    fputs(text, stdout);
    free(text);
    return EXIT_SAME;
}

int fgl_cli_explain(int argc, char **argv)
{
    struct run run = {.frames = 1, .timeout = 60, .suffix = ".txt"};
    int pixel[2] = {-1, -1}, vertex = -1;
    opterr = 0;
    for (int option, which = 0; (option = getopt_long(argc, argv, "", options, &which)) != -1;) {
        bool good = true;
        switch (option) {
        case 'h': fputs(usage, stdout); return EXIT_SAME;
        case '?': return fgl_complain("explain: `%s` is not an option or lacks its value", argv[optind - 1]);
        case 'p': good = read_numbers(optarg, 2, 0, 16383, pixel); break;
        case 'v': good = read_numbers(optarg, 1, 0, 2, &vertex); break;
        case 'j': run.suffix = ".json"; break;
        default: good = fgl_run_option(&run, option, optarg); break;
        }
        if (!good)
            return fgl_complain("explain: --%s cannot be '%s'", options[which].name, optarg);
    }
    if (optind == argc)
        return fgl_complain("explain: which program? `fixedgl explain --help` says more");
    if (pixel[0] < 0)
        return fgl_complain("explain: which pixel? --pixel X,Y counts from the lower left");
    run.argv = argv + optind;
    return explain(&run, pixel, vertex);
}
