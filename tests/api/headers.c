/*
 * The public headers agree with the usual ones: sizes of types, values of tokens, types of functions.
 * Everything is checked when this file is compiled. Programs compiled with other headers run on FixedGL, so
 * none of it may ever change.
 */
#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES
#endif
#include <GL/osmesa.h>
#include <fixedgl.h>

#define SIZE(type, bytes) _Static_assert(sizeof(type) == (bytes), #type)
#define SIGNED(type) _Static_assert((type)-1 < (type)0, #type)
#define UNSIGNED(type) _Static_assert((type)-1 > (type)0, #type)
#define TOKEN(name, value) _Static_assert((name) == (value), #name)

/* GL 1.5, 2.3 "Command Syntax", table 2.2, and what the binary interface on Linux makes of it. */
SIZE(GLboolean, 1);
SIZE(GLbyte, 1);
SIZE(GLubyte, 1);
SIZE(GLshort, 2);
SIZE(GLushort, 2);
SIZE(GLint, 4);
SIZE(GLuint, 4);
SIZE(GLsizei, 4);
SIZE(GLenum, 4);
SIZE(GLbitfield, 4);
SIZE(GLfloat, 4);
SIZE(GLclampf, 4);
SIZE(GLdouble, 8);
SIZE(GLclampd, 8);
SIZE(GLintptr, sizeof(void *));
SIZE(GLsizeiptr, sizeof(void *));
SIGNED(GLbyte);
SIGNED(GLshort);
SIGNED(GLint);
SIGNED(GLsizei);
SIGNED(GLintptr);
SIGNED(GLsizeiptr);
UNSIGNED(GLboolean);
UNSIGNED(GLubyte);
UNSIGNED(GLushort);
UNSIGNED(GLuint);
UNSIGNED(GLenum);
UNSIGNED(GLbitfield);

/* One token of each group that code relies on being consecutive, and some of each version. */
TOKEN(GL_POLYGON, 9);
TOKEN(GL_ALWAYS, GL_NEVER + 7);
TOKEN(GL_LIGHT7, GL_LIGHT0 + 7);
TOKEN(GL_LIGHT0, 0x4000);
TOKEN(GL_CLIP_PLANE5, GL_CLIP_PLANE0 + 5);
TOKEN(GL_CLIP_PLANE0, 0x3000);
TOKEN(GL_TEXTURE31, GL_TEXTURE0 + 31);
TOKEN(GL_TEXTURE0_ARB, GL_TEXTURE0);
TOKEN(GL_SET, GL_CLEAR + 15);
TOKEN(GL_DOUBLE, GL_BYTE + 10);
TOKEN(GL_T4F_C4F_N3F_V4F, GL_V2F + 13);
TOKEN(GL_OUT_OF_MEMORY, GL_INVALID_ENUM + 5);
TOKEN(GL_QUADRATIC_ATTENUATION, GL_AMBIENT + 9);
TOKEN(GL_TEXTURE_CUBE_MAP_NEGATIVE_Z, GL_TEXTURE_CUBE_MAP_POSITIVE_X + 5);
TOKEN(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | GL_ACCUM_BUFFER_BIT, 0x4700);
TOKEN(GL_LOGIC_OP, GL_INDEX_LOGIC_OP);
TOKEN(GL_RGBA8, 0x8058);
TOKEN(GL_RESCALE_NORMAL, 0x803A);
TOKEN(GL_RESCALE_NORMAL_EXT, GL_RESCALE_NORMAL);
TOKEN(GL_SEPARATE_SPECULAR_COLOR, 0x81FA);
TOKEN(GL_BGRA, 0x80E1);
TOKEN(GL_COMBINE, 0x8570);
TOKEN(GL_SRC0_RGB, GL_SOURCE0_RGB);
TOKEN(GL_FOG_COORD_SRC, GL_FOG_COORDINATE_SOURCE);
TOKEN(GL_DEPTH_COMPONENT24, 0x81A6);
TOKEN(GL_ARRAY_BUFFER, 0x8892);
TOKEN(GL_HISTOGRAM, 0x8024);
TOKEN(GL_FRAMEBUFFER_EXT, 0x8D40);
TOKEN(GL_DEPTH_STENCIL_EXT, 0x84F9);
TOKEN(GL_PHONG_WIN, 0x80EA);
TOKEN(GL_LIGHT_MODEL_SPECULAR_VECTOR_APPLE, 0x85B0);
TOKEN(OSMESA_RGBA, 0x1908);
TOKEN(OSMESA_RGB_565, 5);
TOKEN(OSMESA_MAX_HEIGHT, 0x25);
TOKEN(OSMESA_CONTEXT_MINOR_VERSION, 0x37);

/* Names of what FixedGL lacks, from the registry; what announces them stays undefined. */
TOKEN(GL_SHADING_LANGUAGE_VERSION, 0x8B8C);
TOKEN(GL_MAJOR_VERSION, 0x821B);
TOKEN(GL_VERTEX_SHADER, 0x8B31);
TOKEN(GL_TEXTURE_MAX_ANISOTROPY_EXT, 0x84FE);
TOKEN(GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 0x83F3);
TOKEN(GL_DEPTH_STENCIL_TEXTURE_MODE, 0x90EA);
TOKEN(GL_FRAMEBUFFER_SRGB, 0x8DB9);
#if defined(GL_VERSION_2_0) || defined(GL_VERSION_3_0) || defined(GL_EXT_texture_filter_anisotropic)
#error "the headers announce what FixedGL lacks"
#endif

#if !defined(GL_VERSION_1_1) || !defined(GL_VERSION_1_5) || !defined(GL_ARB_multitexture) ||                 \
        !defined(GL_ARB_imaging)
#error "the headers do not say what they hold"
#endif

/* A function and the pointer type that OSMesaGetProcAddress is cast to must agree. */
#define SAME(pointer, function) _Static_assert(_Generic(&(function), pointer : 1, default : 0), #function)

SAME(PFNGLDRAWRANGEELEMENTSPROC, glDrawRangeElements);
SAME(PFNGLACTIVETEXTUREPROC, glActiveTexture);
SAME(PFNGLACTIVETEXTUREARBPROC, glActiveTextureARB);
SAME(PFNGLMULTIDRAWELEMENTSPROC, glMultiDrawElements);
SAME(PFNGLBLENDCOLORPROC, glBlendColor);
SAME(PFNGLMAPBUFFERPROC, glMapBuffer);
SAME(PFNGLBUFFERDATAPROC, glBufferData);
SAME(PFNGLCHECKFRAMEBUFFERSTATUSEXTPROC, glCheckFramebufferStatusEXT);

int main(void)
{
    return 0;
}
