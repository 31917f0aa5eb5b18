/* Stroke and bitmap fonts, both from the one line font in glyphs.h: the first drawn as lines, the second as
 * lines rounded to pixels. */
#include <stdlib.h>
#include <string.h>
#include <GL/freeglut.h>
#include "glyphs.h"
#include "internal.h"

/* Handles: only the addresses count. */
void *glutStrokeRoman, *glutStrokeMonoRoman;
void *glutBitmap9By15, *glutBitmap8By13, *glutBitmapTimesRoman10, *glutBitmapTimesRoman24;
void *glutBitmapHelvetica10, *glutBitmapHelvetica12, *glutBitmapHelvetica18;

struct font {
    void *const handle;
    bool bitmap;
    float capital; /* height of capitals, pixels or object units */
    float advance; /* of every character, 0 for proportional widths */
    float line;    /* height of a line of text */
};

static const struct font fonts[] = {
        {&glutBitmap8By13, true, 9, 8, 14},
        {&glutBitmap9By15, true, 10, 9, 16},
        {&glutBitmapTimesRoman10, true, 7, 0, 14},
        {&glutBitmapTimesRoman24, true, 17, 0, 29},
        {&glutBitmapHelvetica10, true, 7, 0, 14},
        {&glutBitmapHelvetica12, true, 9, 0, 16},
        {&glutBitmapHelvetica18, true, 13, 0, 23},
        {&glutStrokeRoman, false, 100, 0, 152.381f},
        {&glutStrokeMonoRoman, false, 100, 104.76f, 152.381f},
};

static const struct font *find_font(const char *function, void *handle, bool bitmap)
{
    fgl_glut_require_init(function);
    for (size_t i = 0; i < sizeof fonts / sizeof fonts[0]; i++)
        if (fonts[i].handle == handle && fonts[i].bitmap == bitmap)
            return &fonts[i];
    fgl_glut_warn("%s: no such font", function);
    return NULL;
}

static const char *find_glyph(int character)
{
    return character >= GLYPH_FIRST && character <= GLYPH_LAST ? glyphs[character - GLYPH_FIRST] : NULL;
}

/* Pixels or units per step of the grid. */
static float unit(const struct font *font)
{
    return font->capital / GLYPH_CAPITAL;
}

/* Steps of the grid that a glyph is wide; a space as wide as 'r'. */
static int grid_width(const char *glyph)
{
    int width = *glyph ? 0 : 4;
    for (; *glyph; glyph += glyph[2] == ' ' ? 3 : 2)
        width = glyph[0] - '0' > width ? glyph[0] - '0' : width;
    return width;
}

/* Two steps of room after the glyph; mono fonts centre it. */
static float character_width(const struct font *font, int character)
{
    const char *glyph = find_glyph(character);
    if (!glyph)
        return 0;
    if (font->advance > 0)
        return font->advance;
    float width = (float)(grid_width(glyph) + 2) * unit(font);
    return font->bitmap ? (float)(int)(width + 0.5f) : width;
}

static float left_margin(const struct font *font, const char *glyph)
{
    if (font->advance <= 0)
        return font->bitmap ? 0 : unit(font);
    float margin = (font->advance - (float)grid_width(glyph) * unit(font)) / 2;
    return font->bitmap ? (float)(int)margin : margin;
}

static float string_width(const struct font *font, const unsigned char *string)
{
    float widest = 0, width = 0;
    for (; *string; string++) {
        width = *string == '\n' ? 0 : width + character_width(font, *string);
        widest = width > widest ? width : widest;
    }
    return widest;
}

void glutStrokeCharacter(void *handle, int character)
{
    const struct font *font = find_font("glutStrokeCharacter", handle, false);
    const char *glyph = find_glyph(character);
    if (!font || !glyph)
        return;
    float margin = left_margin(font, glyph);
    for (const char *p = glyph; *p; p += *p == ' ') {
        glBegin(GL_LINE_STRIP);
        for (; *p && *p != ' '; p += 2)
            glVertex2f(margin + (float)(p[0] - '0') * unit(font), (float)(p[1] - 'd') * unit(font));
        glEnd();
    }
    glTranslatef(character_width(font, character), 0, 0);
}

int glutStrokeWidth(void *handle, int character)
{
    const struct font *font = find_font("glutStrokeWidth", handle, false);
    return font ? (int)(character_width(font, character) + 0.5f) : 0;
}

int glutStrokeLength(void *handle, const unsigned char *string)
{
    const struct font *font = find_font("glutStrokeLength", handle, false);
    return font ? (int)(string_width(font, string) + 0.5f) : 0;
}

GLfloat glutStrokeWidthf(void *handle, int character)
{
    const struct font *font = find_font("glutStrokeWidthf", handle, false);
    return font ? character_width(font, character) : 0;
}

GLfloat glutStrokeLengthf(void *handle, const unsigned char *string)
{
    const struct font *font = find_font("glutStrokeLengthf", handle, false);
    return font ? string_width(font, string) : 0;
}

GLfloat glutStrokeHeight(void *handle)
{
    const struct font *font = find_font("glutStrokeHeight", handle, false);
    return font ? font->line : 0;
}

void glutStrokeString(void *handle, const unsigned char *string)
{
    const struct font *font = find_font("glutStrokeString", handle, false);
    float width = 0;
    for (; font && *string; string++) {
        if (*string == '\n') {
            glTranslatef(-width, -font->line, 0);
            width = 0;
        } else {
            glutStrokeCharacter(handle, *string);
            width += character_width(font, *string);
        }
    }
}

/* ---- bitmap fonts ---- */

enum { BITMAP_STRIDE = 4, BITMAP_ROWS = 32 }; /* room for 17 pixel capitals */

static int round_pixel(float v)
{
    return (int)(v < 0 ? v - 0.5f : v + 0.5f);
}

static void set_pixel(unsigned char *bits, int x, int y)
{
    if (x >= 0 && y >= 0 && x < 8 * BITMAP_STRIDE && y < BITMAP_ROWS)
        bits[y * BITMAP_STRIDE + x / 8] |= (unsigned char)(0x80 >> x % 8);
}

static void set_line(unsigned char *bits, int x0, int y0, int x1, int y1)
{
    int dx = x1 - x0, dy = y1 - y0, steps = abs(dx) > abs(dy) ? abs(dx) : abs(dy);
    set_pixel(bits, x0, y0);
    for (int i = 1; i <= steps; i++)
        set_pixel(bits, x0 + round_pixel((float)(dx * i) / (float)steps),
                  y0 + round_pixel((float)(dy * i) / (float)steps));
}

static void rasterize(const struct font *font, const char *glyph, int descent, unsigned char *bits)
{
    int margin = (int)left_margin(font, glyph), x = 0, y = 0;
    bool pen_down = false;
    for (const char *p = glyph; *p; p += 2) {
        if (*p == ' ') {
            pen_down = false;
            p++;
        }
        int to_x = margin + round_pixel((float)(p[0] - '0') * unit(font));
        int to_y = descent + round_pixel((float)(p[1] - 'd') * unit(font));
        if (pen_down)
            set_line(bits, x, y, to_x, to_y);
        x = to_x;
        y = to_y;
        pen_down = true;
    }
}

typedef void (*bitmap_function)(GLsizei, GLsizei, GLfloat, GLfloat, GLfloat, GLfloat, const GLubyte *);

/* Looked up and not linked: a core without glBitmap draws no bitmap text, but all else. */
static bitmap_function find_bitmap(void)
{
    static bitmap_function found;
    if (!found)
        found = (bitmap_function)OSMesaGetProcAddress("glBitmap");
    return found;
}

void glutBitmapCharacter(void *handle, int character)
{
    const struct font *font = find_font("glutBitmapCharacter", handle, true);
    const char *glyph = find_glyph(character);
    bitmap_function bitmap = find_bitmap();
    if (!font || !glyph || !bitmap)
        return;
    unsigned char bits[BITMAP_STRIDE * BITMAP_ROWS] = {0};
    int descent = round_pixel(GLYPH_DESCENT * unit(font));
    int width = round_pixel(character_width(font, character));
    rasterize(font, glyph, descent, bits);
    glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
    glPixelStorei(GL_UNPACK_SWAP_BYTES, GL_FALSE);
    glPixelStorei(GL_UNPACK_LSB_FIRST, GL_FALSE);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 8 * BITMAP_STRIDE);
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 0);
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    bitmap(width, descent + (int)font->capital + 1, 0, (float)descent, (float)width, 0, bits);
    glPopClientAttrib();
}

int glutBitmapWidth(void *handle, int character)
{
    const struct font *font = find_font("glutBitmapWidth", handle, true);
    return font ? (int)character_width(font, character) : 0;
}

int glutBitmapLength(void *handle, const unsigned char *string)
{
    const struct font *font = find_font("glutBitmapLength", handle, true);
    return font ? (int)(string_width(font, string) + 0.5f) : 0;
}

int glutBitmapHeight(void *handle)
{
    const struct font *font = find_font("glutBitmapHeight", handle, true);
    return font ? (int)font->line : 0;
}

void glutBitmapString(void *handle, const unsigned char *string)
{
    const struct font *font = find_font("glutBitmapString", handle, true);
    bitmap_function bitmap = find_bitmap();
    float width = 0;
    for (; font && bitmap && *string; string++) {
        if (*string == '\n') {
            bitmap(0, 0, 0, 0, -width, -font->line, NULL);
            width = 0;
        } else {
            glutBitmapCharacter(handle, *string);
            width += character_width(font, *string);
        }
    }
}
