/*
 * aapoly: polygons that share pixels at their edges.
 *
 * An antialiased polygon covers a part of the pixels at its edge. Drawn from front to back without a depth
 * buffer, the destination's alpha counts what is already covered, and saturated blending lets each next
 * polygon fill only what is left. Polygon antialiasing may be missing in an implementation: then the edges
 * have steps, but the order works just the same.
 *
 *   t             saturated blending and smoothing on and off
 *   left, right   turn
 *
 * GL 1.5, 3.5.3 "Antialiasing" and 4.1.8 "Blending" (SRC_ALPHA_SATURATE).
 */
#include <GL/glut.h>
#include <math.h>

enum { PETALS = 12, LAYERS = 4 };

static GLboolean smooth = GL_TRUE;
static int angle; /* degrees */

static void draw_petal(float length, float breadth)
{
    glBegin(GL_POLYGON);
    glVertex2f(0, 0);
    for (int i = 0; i <= 12; i++) {
        const float t = -1 + (float)i / 6;
        glVertex2f(length * (1 - 0.45f * t * t), breadth * sinf(2.2f * t) * (1 - 0.3f * t * t));
    }
    glEnd();
}

/* The front layer first. */
static void draw_flower(void)
{
    glColor3f(0.98f, 0.80f, 0.25f);
    glBegin(GL_POLYGON);
    for (int i = 0; i < 24; i++)
        glVertex2f(0.2f * cosf(0.261799f * (float)i), 0.2f * sinf(0.261799f * (float)i));
    glEnd();
    for (int layer = 0; layer < LAYERS; layer++)
        for (int i = 0; i < PETALS; i++) {
            const float shade = 1 - 0.16f * (float)layer - 0.03f * (float)(i % 4);
            glPushMatrix();
            glRotatef(360.0f * (float)i / PETALS + 11.0f * (float)layer, 0, 0, 1);
            glColor3f(0.95f * shade, 0.45f * shade, 0.60f * shade);
            draw_petal(0.45f + 0.16f * (float)layer, 0.09f + 0.02f * (float)layer);
            glPopMatrix();
        }
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT);
    if (smooth) {
        glEnable(GL_POLYGON_SMOOTH);
        glEnable(GL_BLEND);
    } else {
        glDisable(GL_POLYGON_SMOOTH);
        glDisable(GL_BLEND);
    }
    glPushMatrix();
    glRotatef((float)angle, 0, 0, 1);
    draw_flower();
    glPopMatrix();
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluOrtho2D(-(double)width / height, (double)width / height, -1, 1);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 't')
        smooth = !smooth;
    glutPostRedisplay();
}

static void special(int key, int x, int y)
{
    (void)x, (void)y;
    angle += 5 * ((key == GLUT_KEY_LEFT) - (key == GLUT_KEY_RIGHT));
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_ALPHA);
    glutInitWindowSize(320, 240);
    glutCreateWindow("aapoly");
    glClearColor(0, 0, 0, 0); /* nothing is covered yet */
    glBlendFunc(GL_SRC_ALPHA_SATURATE, GL_ONE);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutSpecialFunc(special);
    glutMainLoop();
    return 0;
}
