/* Making mipmaps (GL 1.5, 3.8.8 "Automatic Mipmap Generation"). Layer 2. */
#ifndef FGL_TEXTURE_MIPMAP_H
#define FGL_TEXTURE_MIPMAP_H

#include "texture/image.h"

/* Makes the levels after the base level of one face from it, down to 1x1x1 or the max level. Nothing happens without a base image. Returns
 * false when memory is short: levels that were made stay. */
bool fgl_texture_generate_mipmaps(struct texture_object *object, int face);

#endif
