/* GL_TEXTURE_BIT of the attribute stack. */
#ifndef FGL_API_TEXTURE_ATTRIB_H
#define FGL_API_TEXTURE_ATTRIB_H

#include "state/context.h"

/* Names and parameters of the bound textures into the entry, whose `state` is already saved. */
void fgl_textures_save(const struct context *ctx, struct attrib_entry *e);
void fgl_textures_restore(struct context *ctx, const struct attrib_entry *e);

#endif
