/* Sampler objects (GL_ARB_sampler_objects): texture parameters that belong to a unit, shared between contexts as textures are. The objects
 * themselves: texture/texture.h. */
#ifndef FGL_API_SAMPLER_H
#define FGL_API_SAMPLER_H

struct sampler_store *fgl_sampler_store_create(void); /* NULL: memory is short */
void fgl_sampler_store_retain(struct sampler_store *store);
void fgl_sampler_store_release(struct sampler_store *store);

#endif
