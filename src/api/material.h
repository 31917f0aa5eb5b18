/* Materials (GL 1.5, 2.14.2 "Lighting Parameter Specification", 2.14.3 "ColorMaterial"). */
#ifndef FGL_API_MATERIAL_H
#define FGL_API_MATERIAL_H

#include "state/context.h"

/* While GL_COLOR_MATERIAL is enabled, gives the tracked parameters the current colour. For whoever changes
 * either. */
void fgl_material_track_color(struct context *ctx);
/* Whether the vertex attribute is a material parameter that follows the current colour, which glMaterial does not reach. */
bool fgl_material_is_tracked(const struct context *ctx, int attr);

#endif
