/* Shortens a script for as long as the two libraries still differ on it. */
#ifndef FUZZ_MINIMIZE_H
#define FUZZ_MINIMIZE_H

#include "worker.h"

/* channel->script differs, with the outcome given; on return it is a shorter one that has the same outcome. Runs at most
 * `tries` scripts. Returns how the shorter one differs. */
struct difference minimize(struct channel *channel, enum outcome outcome, int tries);

#endif
