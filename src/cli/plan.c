/* fixedgl plan. */
#define _POSIX_C_SOURCE 200809L
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>

#include "cli.h"
#include "run.h"
#include "support.h"

static const char usage[] = "usage: fixedgl plan PROGRAM [OPTION...] [-- ARGUMENT...]\n"
                            "\n"
                            "Runs a program that is linked with libfixedglut, headless, and prints the plans "
                            "of its draws: the stages\n"
                            "of each, what each term costs by vertex and by pixel on this machine, and what "
                            "was left out, and why.\n"
                            "\n"
                            "  --frames N           frames to draw               (1)\n"
                            "  --events SCRIPT      input after that, in the form of FIXEDGL_EVENTS\n"
                            "  --size WxH           the window's size\n"
                            "  --timeout SECONDS    for the program              (60)\n"
                            "\n"
                            "Exit status: 0, or 2 if the program could not be run.\n";

static const struct option options[] = {
        {"frames", required_argument, NULL, 'f'}, {"events", required_argument, NULL, 'e'},
        {"size", required_argument, NULL, 's'},   {"timeout", required_argument, NULL, 't'},
        {"help", no_argument, NULL, 'h'},         {NULL, 0, NULL, 0},
};

int fgl_cli_plan(int argc, char **argv)
{
    struct run run = {.frames = 1, .timeout = 60, .suffix = ".txt", .set = {"FIXEDGL_PLAN_OUT="}};
    struct problem problem;
    opterr = 0;
    for (int option, which = 0; (option = getopt_long(argc, argv, "", options, &which)) != -1;) {
        if (option == 'h') {
            fputs(usage, stdout);
            return EXIT_SAME;
        }
        if (option == '?')
            return fgl_complain("plan: `%s` is not an option or lacks its value", argv[optind - 1]);
        if (!fgl_run_option(&run, option, optarg))
            return fgl_complain("plan: --%s cannot be '%s'", options[which].name, optarg);
    }
    if (optind == argc)
        return fgl_complain("plan: which program? `fixedgl plan --help` says more");
    run.argv = argv + optind;
    char *text = fgl_run(&run, &problem);
    if (!text)
        return fgl_complain("plan: %s", problem.text);
    fputs(text, stdout);
    free(text);
    return EXIT_SAME;
}
