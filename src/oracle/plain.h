/* What a straightforward program computes: the lighting equation in float, guarded against nothing. */
#ifndef ORACLE_PLAIN_H
#define ORACLE_PLAIN_H

#include "oracle/scene.h"

void oracle_plain(const struct oracle_scene *scene, float rgba[ORACLE_VERTICES][4]);

#endif
