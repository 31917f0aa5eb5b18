/* Delta debugging: takes ranges of commands away, long ones first, then rounds numbers. */
#include "minimize.h"

#include "fair.h"

#include <math.h>

struct search {
    struct channel *channel;
    enum outcome outcome;
    int tries, preamble; /* preamble: commands at the start that stay as they are */
    unsigned unfair; /* what it has, and may keep */
};

static struct script best, candidate;

/* Runs `candidate`; keeps it if it differs in the same way. */
static bool keeps(struct search *search)
{
    if (search->tries <= 0 || (script_unfair(&candidate) & ~search->unfair))
        return false;
    search->tries--;
    search->channel->script = candidate;
    if (workers_compare(search->channel).outcome != search->outcome)
        return false;
    best = candidate;
    return true;
}

/* The clears, GL_NORMALIZE and the first shininess, without which named departures are drawn. */
static int preamble_of(const struct script *s)
{
    int ops = 0;
    while (ops < s->ops && ((s->op[ops].command >= CMD_Clear && s->op[ops].command <= CMD_ClearStencil) ||
                            s->op[ops].command == CMD_Materialf || s->op[ops].command == CMD_Enable))
        ops++;
    return ops;
}

static bool drop_ranges(struct search *search, int length)
{
    bool dropped = false;
    for (int from = best.ops - 1; from >= search->preamble && search->tries > 0; from--) {
        const int to = script_range(&best, from, length);
        if (to < 0 || (to - from > 2 * length && length > 1))
            continue;
        script_without(&candidate, &best, from, to);
        if (keeps(search))
            dropped = true;
        else if (length > 1)
            from -= length / 2;
        if (from > best.ops)
            from = best.ops;
    }
    return dropped;
}

/* Rounds the values of one op; halves and integers first. */
static bool simplify_op(struct search *search, int op)
{
    static const double steps[] = {1.0, 0.5, 0.125, 0.01};
    const int first = best.op[op].first, end = first + best.op[op].values;
    if (end - first > 64)
        return false;
    for (int s = 0; s < 4; s++) {
        bool changed = false;
        candidate = best;
        for (int i = first; i < end; i++) {
            const double rounded = (double)(float)(round(candidate.value[i] / steps[s]) * steps[s]);
            candidate.value[i] = rounded == 0.0 ? candidate.value[i] : rounded; /* no scale by 0, no zero vector */
            changed |= candidate.value[i] != best.value[i];
        }
        if (!changed)
            return false;
        if (keeps(search))
            return true;
    }
    return false;
}

struct difference minimize(struct channel *channel, enum outcome outcome, int tries)
{
    best = channel->script;
    struct search search = {channel, outcome, tries, preamble_of(&best), script_unfair(&best)};
    for (int length = best.ops / 2; length > 1; length /= 2)
        drop_ranges(&search, length);
    while (drop_ranges(&search, 1))
        ;
    for (int op = best.ops - 1; op >= search.preamble; op--)
        simplify_op(&search, op);
    channel->script = best;
    return workers_compare(channel);
}
