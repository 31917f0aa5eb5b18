/* fixedgl info. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli.h"
#include "library.h"
#include "support.h"

static const char usage[] =
        "usage: fixedgl info [LIBRARY]\n\n"
        "Prints what a library with the OSMesa API says about itself: without LIBRARY, what\n"
        "FixedGL and the system's OSMesa say, and whether this CPU draws OSMesa's pictures.\n";

static void print_library(const char *title, const char *library)
{
    struct library_facts facts;
    struct problem problem;
    printf("%s\n", title);
    if (!fgl_library_query(library, &facts, &problem)) {
        printf("  not available: %s\n\n", problem.text);
        return;
    }
    printf("  library      %s\n", facts.path);
    if (facts.package[0] != '\0')
        printf("  package      %s\n", facts.package);
    printf("  GL_VENDOR    %s\n  GL_RENDERER  %s\n  GL_VERSION   %s\n", facts.vendor, facts.renderer,
           facts.version);
    printf("  extensions   %d; `fixedgl info %s` lists them\n\n", facts.extensions, library);
}

int fgl_cli_info(int argc, char **argv)
{
    struct problem problem;
    if (argc == 2 && strcmp(argv[1], "--help") == 0) {
        fputs(usage, stdout);
        return EXIT_SAME;
    }
    if (argc > 2 || (argc == 2 && argv[1][0] == '-'))
        return fgl_complain("usage: fixedgl info [LIBRARY]");
    if (argc == 2)
        return fgl_library_print(argv[1], &problem) ? EXIT_SAME : fgl_complain("%s", problem.text);
    char *own = fgl_library_own();
    print_library("FixedGL", own);
    print_library("OSMesa", "libOSMesa.so.8");
    printf("CPU\n  FMA          %s\n", fgl_cpu_has_fma() ? "yes" : "no: OSMesa draws other pictures here");
    free(own);
    return EXIT_SAME;
}
