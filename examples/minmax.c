/*
 * minmax: a dim picture made to use the whole range.
 *
 * On the left a foggy scene, whose colors lie close together. Its least and greatest values of red, green and
 * blue are found while it is copied to nowhere; on the right it is copied again, scaled and biased so that they
 * become 0 and 1.
 *
 *   + -   more or less fog
 *   t     all three channels together, which keeps the hues
 *
 * GL 1.5, 3.6.3 "Minmax Table Specification", 3.6.5 "Minmax", 6.1.10 (GL_ARB_imaging).
 */
#define GL_GLEXT_PROTOTYPES
#include <GL/glut.h>
#include <stdio.h>
#include <stdlib.h>

enum { SIDE = 200, GAP = 10 };

static float density = 0.9f;
static GLboolean together;

static void draw_scene(void)
{
    static const GLfloat light[4] = {1, 2, 2, 0}, mist[4] = {0.55f, 0.56f, 0.6f, 1};
    static const GLfloat colors[3][4] = {{0.8f, 0.3f, 0.2f, 1}, {0.3f, 0.7f, 0.3f, 1}, {0.3f, 0.4f, 0.9f, 1}};
    glViewport(GAP, GAP, SIDE, SIDE);
    glLightfv(GL_LIGHT0, GL_POSITION, light);
    glFogfv(GL_FOG_COLOR, mist);
    glFogf(GL_FOG_DENSITY, density);
    glFogi(GL_FOG_MODE, GL_EXP);
    glScissor(GAP, GAP, SIDE, SIDE);
    glEnable(GL_SCISSOR_TEST);
    glClearColor(mist[0], mist[1], mist[2], 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_FOG);
    glEnable(GL_DEPTH_TEST);
    for (int i = 0; i < 3; i++) {
        glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, colors[i]);
        glPushMatrix();
        glTranslatef(0.5f * (float)(i - 1), 0.3f * (float)(1 - i), -0.9f - 0.4f * (float)i);
        glutSolidSphere(0.38, 40, 30);
        glPopMatrix();
    }
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_FOG);
    glDisable(GL_LIGHTING);
}

/* The limits of each channel: limit[0] the least, limit[1] the greatest value. */
static void measure(GLfloat limit[2][3])
{
    glMinmax(GL_MINMAX, GL_RGB, GL_TRUE);
    glEnable(GL_MINMAX);
    glWindowPos2i(0, 0);
    glCopyPixels(GAP, GAP, SIDE, SIDE, GL_COLOR);
    glGetMinmax(GL_MINMAX, GL_TRUE, GL_RGB, GL_FLOAT, limit);
    glDisable(GL_MINMAX);
    for (int c = 1; together && c < 6; c++) {
        GLfloat *first = limit[c / 3], *v = &limit[c / 3][c % 3];
        if (c / 3 ? *v > first[0] : *v < first[0])
            first[0] = *v;
    }
}

static void stretch(GLfloat limit[2][3])
{
    static const GLenum scale[3] = {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE},
                        bias[3] = {GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS};
    glPushAttrib(GL_PIXEL_MODE_BIT);
    for (int c = 0; c < 3; c++) {
        const int from = together ? 0 : c;
        const float range = limit[1][from] - limit[0][from];
        glPixelTransferf(scale[c], range > 0 ? 1 / range : 1);
        glPixelTransferf(bias[c], range > 0 ? -limit[0][from] / range : 0);
    }
    glWindowPos2i(2 * GAP + SIDE, GAP);
    glCopyPixels(GAP, GAP, SIDE, SIDE, GL_COLOR);
    glPopAttrib();
}

static void display(void)
{
    GLfloat limit[2][3];
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw_scene();
    measure(limit);
    stretch(limit);
    glutSwapBuffers();
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    density += 0.15f * (float)((key == '+' && density < 3) - (key == '-' && density > 0.2f));
    together ^= key == 't';
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(2 * SIDE + 3 * GAP, SIDE + 2 * GAP);
    glutCreateWindow("minmax");
    if (!glutExtensionSupported("GL_ARB_imaging")) {
        fprintf(stderr, "minmax: this OpenGL has no imaging subset\n");
        exit(1);
    }
    glEnable(GL_LIGHT0);
    glMatrixMode(GL_PROJECTION);
    glOrtho(-1, 1, -1, 1, 0, 3);
    glMatrixMode(GL_MODELVIEW);
    glutDisplayFunc(display);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
