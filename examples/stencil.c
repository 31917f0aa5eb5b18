/*
 * stencil: another world through a star.
 *
 * Drawing the star into the stencil buffer alone inverts the buffer under each triangle of a fan. What an odd
 * number of triangles covers is inside: that fills any outline, even one that crosses itself. The scenes are
 * then drawn where the stencil is set, and where it is not.
 *
 *   i             inside out
 *   left, right   turn the star
 *
 * GL 1.5, 4.1.5 "Stencil Test".
 */
#include <GL/glut.h>
#include <math.h>

static GLboolean swapped;
static int angle; /* degrees */

static void draw_star(void)
{
    glBegin(GL_TRIANGLE_FAN);
    for (int i = 0; i <= 7; i++) /* every third of seven corners */
        glVertex2f(0.93f * sinf(2.6927937f * (float)i), 0.93f * cosf(2.6927937f * (float)i));
    glEnd();
}

static void make_stencil(void)
{
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glStencilFunc(GL_ALWAYS, 0, 1);
    glStencilOp(GL_KEEP, GL_INVERT, GL_INVERT);
    glPushMatrix();
    glRotatef((float)angle, 0, 0, 1);
    draw_star();
    glPopMatrix();
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
}

static void draw_gradient(const float *below, const float *above)
{
    glBegin(GL_QUADS);
    glColor3fv(below);
    glVertex2i(-2, -1);
    glVertex2i(2, -1);
    glColor3fv(above);
    glVertex2i(2, 1);
    glVertex2i(-2, 1);
    glEnd();
}

static void draw_planet(float red, float green, float blue)
{
    glPushAttrib(GL_ENABLE_BIT);
    glEnable(GL_LIGHTING);
    glEnable(GL_DEPTH_TEST);
    glColor3f(red, green, blue);
    glPushMatrix();
    glRotatef(-72, 1, 0.35f, 0);
    glutSolidSphere(0.42, 48, 32);
    glutSolidTorus(0.05, 0.68, 12, 72);
    glPopMatrix();
    glPopAttrib();
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glEnable(GL_STENCIL_TEST);
    make_stencil();
    glStencilFunc(swapped ? GL_NOTEQUAL : GL_EQUAL, 1, 1);
    draw_gradient((float[]){0.98f, 0.82f, 0.50f}, (float[]){0.85f, 0.36f, 0.30f});
    draw_planet(0.25f, 0.45f, 0.62f);
    glStencilFunc(swapped ? GL_EQUAL : GL_NOTEQUAL, 1, 1);
    draw_gradient((float[]){0.14f, 0.16f, 0.30f}, (float[]){0.05f, 0.05f, 0.11f});
    draw_planet(0.75f, 0.70f, 0.95f);
    glDisable(GL_STENCIL_TEST);
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(-(double)width / height, (double)width / height, -1, 1, -1, 1);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 'i')
        swapped = !swapped;
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
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH | GLUT_STENCIL);
    glutInitWindowSize(320, 240);
    glutCreateWindow("stencil");
    glLightfv(GL_LIGHT0, GL_POSITION, (float[]){-1, 1, 1.5f, 0});
    glEnable(GL_LIGHT0);
    glEnable(GL_COLOR_MATERIAL);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutSpecialFunc(special);
    glutMainLoop();
    return 0;
}
