/* Feedback and selection (GL 1.5, 5.2 "Selection", 5.3 "Feedback"): in these render modes primitives, clipped
 * and culled, go into the program's buffers in place of the framebuffer. Validation puts the functions of
 * this file where the rasterizer's stand; a plan made in GL_RENDER mode knows nothing of them. */
#ifndef FGL_PIPELINE_FEEDBACK_H
#define FGL_PIPELINE_FEEDBACK_H

#include "base/batch.h"
#include "state/context.h"

struct plan;

/* What a plan holds for feedback. */
struct feedback_plan {
    bool texture_coords; /* raster vertices get the first unit's */
};

/* Turns the rasterizer's plan into one for ctx->render_mode, not GL_RENDER. */
void fgl_feedback_validate(struct context *ctx, struct plan *plan);

/* Texture coordinates into the records of a batch. */
void fgl_feedback_emit(const struct plan *plan, const struct vertex_batch *batch, unsigned char *record);

/* One more value into the feedback buffer, if it has room. */
void fgl_feedback_value(struct feedback_state *f, float value);

/* A vertex, as much of it as the buffer's type asks for. window: y up; w is w_clip. color: in colour index
 * mode the index alone. */
void fgl_feedback_vertex(struct context *ctx, const float window[4], const float color[4],
                         const float texture_coords[4]);

/* What glBitmap, glDrawPixels and glCopyPixels do in GL_FEEDBACK mode in place of drawing: their token and
 * the raster position, if valid. */
void fgl_feedback_raster_position(struct context *ctx, GLenum token);

/* Something at window depth z, 0..1, is drawn while selecting; also a valid glRasterPos. */
void fgl_selection_hit(struct selection_state *s, float z);

#endif
