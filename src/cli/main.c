/* fixedgl: the command line tool. This file holds the table of its subcommands, and nothing of what they do.
 */
#include <stdio.h>
#include <string.h>

#include <fixedgl.h>

#include "cli.h"
#include "support.h"

struct subcommand {
    const char *name;
    const char *summary;
    int (*run)(int argc, char **argv);
};

static const struct subcommand subcommands[] = {
        {"diff", "draw every example with FixedGL and OSMesa and compare them byte by byte", fgl_cli_diff},
        {"explain", "run a program and print why a pixel has its colour", fgl_cli_explain},
        {"info", "print what FixedGL and OSMesa say about themselves", fgl_cli_info},
        {"plan", "run a program and print the plans of its draws, with their costs", fgl_cli_plan},
        {"tradeoff", "measure speed and accuracy of each mode, and of OSMesa", fgl_cli_tradeoff},
};

static int print_help(void)
{
    printf("usage: fixedgl SUBCOMMAND [OPTION...] [ARGUMENT...]\n\n");
    for (size_t i = 0; i < sizeof subcommands / sizeof *subcommands; i++)
        printf("  %-10s %s\n", subcommands[i].name, subcommands[i].summary);
    printf("\n  fixedgl SUBCOMMAND --help   its options\n  fixedgl --version           the version\n");
    return EXIT_SAME;
}

int main(int argc, char **argv)
{
    if (argc < 2)
        return fgl_complain("which subcommand? `fixedgl --help` lists them");
    if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0 || strcmp(argv[1], "help") == 0)
        return print_help();
    if (strcmp(argv[1], "--version") == 0) {
        printf("fixedgl %s\n", FIXEDGL_VERSION);
        return EXIT_SAME;
    }
    for (size_t i = 0; i < sizeof subcommands / sizeof *subcommands; i++)
        if (strcmp(argv[1], subcommands[i].name) == 0)
            return subcommands[i].run(argc - 1, argv + 1);
    return fgl_complain("there is no subcommand '%s'; `fixedgl --help` lists them", argv[1]);
}
