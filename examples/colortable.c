/*
 * colortable: heights as colors.
 *
 * The picture is one number a pixel, the height of a landscape. A color table makes each number a color while
 * the pixels are drawn: on the left as they are, on the right as on a map. Nothing is computed again when the
 * table changes.
 *
 *   c        the next table
 *   + -      raise or lower the sea
 *
 * GL 1.5, 3.6.3 "Color Table Specification", 3.6.5 "Color Table Lookup" (GL_ARB_imaging).
 */
#include <GL/glut.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { SIDE = 180, ENTRIES = 256 };

static GLubyte height_of[SIDE][SIDE];
static int palette, sea = 80; /* of 0 to 255 */

/* Hills around three peaks. */
static void make_heights(void)
{
    static const float peak[3][3] = {{0.28f, 0.35f, 0.8f}, {0.7f, 0.55f, 0.65f}, {0.35f, 0.85f, 0.45f}};
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++) {
            float h = 0.12f + 0.05f * sinf(0.11f * (float)x) * cosf(0.09f * (float)y);
            for (int p = 0; p < 3; p++) {
                const float dx = (float)x / SIDE - peak[p][0], dy = (float)y / SIDE - peak[p][1];
                h += peak[p][2] * expf(-22 * (dx * dx + dy * dy));
            }
            height_of[y][x] = (GLubyte)(h > 1 ? 255 : 255 * h);
        }
}

/* Below the sea blue, then from the shore up; or bands, to count the heights by. */
static void entry(int h, GLfloat rgb[3])
{
    const float depth = (float)h / (float)sea, land = (float)(h - sea) / (float)(256 - sea);
    if (palette == 1) {
        rgb[0] = rgb[1] = rgb[2] = h / 16 % 2 ? 0.85f : 0.2f;
    } else if (h < sea) {
        rgb[0] = 0.05f + 0.1f * depth;
        rgb[1] = 0.1f + 0.4f * depth * depth;
        rgb[2] = 0.35f + 0.4f * depth;
    } else {
        rgb[0] = 0.35f + 0.65f * land;
        rgb[1] = 0.55f + 0.4f * land * land;
        rgb[2] = 0.25f + 0.7f * land * land;
    }
}

static void make_table(void)
{
    GLfloat table[ENTRIES][3];
    for (int h = 0; h < ENTRIES; h++)
        entry(h, table[h]);
    glColorTable(GL_COLOR_TABLE, GL_RGB, ENTRIES, GL_RGB, GL_FLOAT, table);
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT);
    make_table();
    glRasterPos2i(15, 30);
    glDrawPixels(SIDE, SIDE, GL_LUMINANCE, GL_UNSIGNED_BYTE, height_of);
    glRasterPos2i(SIDE + 25, 30);
    glEnable(GL_COLOR_TABLE);
    glDrawPixels(SIDE, SIDE, GL_LUMINANCE, GL_UNSIGNED_BYTE, height_of);
    glDisable(GL_COLOR_TABLE);
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluOrtho2D(0, width, 0, height);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    palette = key == 'c' ? 1 - palette : palette;
    sea += 8 * ((key == '+' && sea < 240) - (key == '-' && sea > 16));
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB);
    glutInitWindowSize(400, 240);
    glutCreateWindow("colortable");
    if (!glutExtensionSupported("GL_ARB_imaging")) {
        fprintf(stderr, "colortable: this OpenGL has no imaging subset\n");
        exit(1);
    }
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    make_heights();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
