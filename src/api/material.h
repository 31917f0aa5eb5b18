/* Materials (GL 1.5, 2.14.2 "Lighting Parameter Specification", 2.14.3 "ColorMaterial"). */
#ifndef FGL_API_MATERIAL_H
#define FGL_API_MATERIAL_H

#include "state/context.h"

/* While GL_COLOR_MATERIAL is enabled, gives the tracked parameters the current colour. For whoever changes
 * either. */
void fgl_material_track_color(struct context *ctx);

#endif
