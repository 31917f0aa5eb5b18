/* The constant parts of the report's page: style and script. Both are inside the page, so it needs no
 * network. */
#ifndef FGL_CLI_REPORT_PAGE_H
#define FGL_CLI_REPORT_PAGE_H

/* Everything before the first heading; a style sheet for light and dark. */
extern const char fgl_report_page_head[];

/* Everything after the last picture: the enlarged view and the script that fills it. */
extern const char fgl_report_page_foot[];

#endif
