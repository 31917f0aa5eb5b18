/* The subcommands of the command line tool. Each gets its own name as argv[0] and returns an exit code. */
#ifndef FGL_CLI_CLI_H
#define FGL_CLI_CLI_H

/* Draws every picture of a list with FixedGL and with the reference, and compares them; or records goldens.
 */
int fgl_cli_diff(int argc, char **argv);

/* Runs a program and prints why a pixel of its picture has its colour. */
int fgl_cli_explain(int argc, char **argv);

/* Runs a program and prints the plans of its draws, with their costs. */
int fgl_cli_plan(int argc, char **argv);

/* Measures speed and accuracy of each mode and of OSMesa. */
int fgl_cli_tradeoff(int argc, char **argv);

/* Prints what FixedGL, OSMesa or a given library says about itself. */
int fgl_cli_info(int argc, char **argv);

#endif
