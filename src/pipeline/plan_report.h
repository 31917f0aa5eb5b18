/* The report behind `fixedgl plan`: the distinct plans of a program's draws, how much was drawn with each,
 * what each term costs here and now, and what is left out. Layer 4. FIXEDGL_PLAN_OUT=file makes the first
 * context of a process write one at each glFinish. */
#ifndef FGL_PIPELINE_PLAN_REPORT_H
#define FGL_PIPELINE_PLAN_REPORT_H

#include "pipeline/pipeline.h"
#include "pipeline/text.h"

/* plan_report.c */
void fgl_plan_report_from_environment(struct pipeline *p);
void fgl_plan_report_free(struct pipeline *p);
/* A draw with the current plan, of so many vertices from `first` on. */
void fgl_plan_report_note(struct context *ctx, const struct vertex_source *source, uint32_t first,
                          int vertices);
void fgl_plan_report_write(const struct pipeline *p);

/* plan_text.c: lines, each with a newline. */
void fgl_plan_describe(struct text *t, const struct plan *plan);
void fgl_plan_left_out(struct text *t, const struct context *ctx, const struct plan *plan);

/* plan_time.c: the costs of the current plan's terms, measured over vertices of the draw, as lines. */
void fgl_plan_time(struct text *t, struct context *ctx, const struct vertex_source *source, uint32_t first,
                   int vertices);

#endif
