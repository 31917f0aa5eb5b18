#include "pipeline/plan_report.h"

#include "fixedgl.h"

#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { REPORT_PLANS = 32 };

struct plan_entry {
    struct text words, costs, left_out; /* a plan is known by its words and what it leaves out */
    int draws;
    int64_t vertices;
};

struct plan_report {
    const char *out;
    struct plan_entry plan[REPORT_PLANS];
    int plans;
    int draws;      /* all */
    int unreported; /* draws with further plans, for which there was no room */
};

void fgl_plan_report_from_environment(struct pipeline *p)
{
    static atomic_flag taken = ATOMIC_FLAG_INIT;
    const char *out = getenv("FIXEDGL_PLAN_OUT");
    if (!out || atomic_flag_test_and_set(&taken))
        return;
    p->report = calloc(1, sizeof *p->report);
    if (p->report)
        p->report->out = out;
}

void fgl_plan_report_free(struct pipeline *p)
{
    for (int i = 0; p->report && i < p->report->plans; i++) {
        fgl_text_free(&p->report->plan[i].words);
        fgl_text_free(&p->report->plan[i].costs);
        fgl_text_free(&p->report->plan[i].left_out);
    }
    free(p->report);
    p->report = NULL;
}

static bool same_text(const struct text *a, const struct text *b)
{
    return a->length == b->length && a->data && b->data && memcmp(a->data, b->data, a->length) == 0;
}

/* The entry of these words, a new one if there is none yet; NULL when there is no room. Takes the texts of a
 * new one. */
static struct plan_entry *entry_of(struct plan_report *r, struct text *words, struct text *left_out,
                                   bool *is_new)
{
    *is_new = false;
    for (int i = 0; i < r->plans; i++)
        if (same_text(words, &r->plan[i].words) && same_text(left_out, &r->plan[i].left_out))
            return &r->plan[i];
    if (r->plans == REPORT_PLANS)
        return NULL;
    struct plan_entry *entry = &r->plan[r->plans++];
    entry->words = *words;
    entry->left_out = *left_out;
    *words = *left_out = (struct text){0};
    *is_new = true;
    return entry;
}

void fgl_plan_report_note(struct context *ctx, const struct vertex_source *source, uint32_t first,
                          int vertices)
{
    struct plan_report *r = ctx->pipeline->report;
    struct text words = {0}, left_out = {0};
    bool is_new;
    r->draws++;
    fgl_plan_describe(&words, &ctx->pipeline->plan);
    fgl_plan_left_out(&left_out, ctx, &ctx->pipeline->plan);
    struct plan_entry *entry = entry_of(r, &words, &left_out, &is_new);
    if (entry) {
        entry->draws++;
        entry->vertices += vertices;
    } else {
        r->unreported++;
    }
    if (is_new)
        fgl_plan_time(&entry->costs, ctx, source, first, vertices);
    fgl_text_free(&words);
    fgl_text_free(&left_out);
}

void fgl_plan_report_write(const struct pipeline *p)
{
    const struct plan_report *r = p->report;
    struct text t = {0};
    fgl_text_add(&t,
                 "%d draw%s with %d plan%s. Costs: measured now, one thread, %s kernels%s; of a term, what\n"
                 "leaving it out would save; below zero where the kernels without it are slower.\n",
                 r->draws, r->draws == 1 ? "" : "s", r->plans, r->plans == 1 ? "" : "s",
                 fgl_vertex_kernels(p->plan.vertex.arith)->isa, p->general ? ", FIXEDGL_PATH=general" : "");
    for (int i = 0; i < r->plans; i++) {
        const struct plan_entry *e = &r->plan[i];
        fgl_text_add(&t, "\nPlan %d: %d draw%s, %lld vertices\n%s%s  left out\n%s", i + 1, e->draws,
                     e->draws == 1 ? "" : "s", (long long)e->vertices, e->words.data,
                     e->costs.data ? e->costs.data : "", e->left_out.data ? e->left_out.data : "");
    }
    if (r->unreported)
        fgl_text_add(&t, "\n%d draws more, with plans beyond the first %d.\n", r->unreported, REPORT_PLANS);
    if (!fgl_text_write(&t, r->out))
        fprintf(stderr, "FixedGL: cannot write %s\n", r->out);
    fgl_text_free(&t);
}
