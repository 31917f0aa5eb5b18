/*
 * clip: a planet with a piece cut out.
 *
 * A shell without one octant is the union of three half shells, so each shell is drawn three times, each time
 * clipped by another plane. A plane is transformed by the modelview matrix of the moment it is given: the cut
 * turns with the planet. What it lays open are the backs of the shells, which have a darker material. The
 * core is whole.
 *
 *   x, y, z   that plane's halves are drawn or left out
 *   arrows    turn the planet
 *
 * GL 1.5, 2.12 "Clipping" and 2.14.1 "Lighting" (two-sided).
 */
#include <GL/glut.h>

static GLboolean drawn[3] = {GL_TRUE, GL_TRUE, GL_TRUE}; /* the halves with x, y, z <= 0 */
static int pitch = 30, yaw = -40;                        /* degrees */

static void set_color(float red, float green, float blue)
{
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (float[]){red, green, blue, 1});
    glMaterialfv(GL_BACK, GL_AMBIENT_AND_DIFFUSE, (float[]){0.6f * red, 0.6f * green, 0.6f * blue, 1});
}

static void draw_shell(double radius)
{
    for (int axis = 0; axis < 3; axis++) {
        double plane[4] = {0, 0, 0, 0};
        plane[axis] = -1;
        glClipPlane(GL_CLIP_PLANE0, plane);
        if (drawn[axis])
            glutSolidSphere(radius, 64, 48);
    }
}

static void draw_planet(void)
{
    glEnable(GL_CLIP_PLANE0);
    set_color(0.22f, 0.48f, 0.62f);
    draw_shell(1.4);
    set_color(0.58f, 0.36f, 0.22f);
    draw_shell(1.28);
    set_color(0.82f, 0.30f, 0.14f);
    draw_shell(0.95);
    glDisable(GL_CLIP_PLANE0);
    set_color(0.98f, 0.78f, 0.25f);
    glutSolidSphere(0.5, 64, 48);
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glPushMatrix();
    glRotatef((float)pitch, 1, 0, 0);
    glRotatef((float)yaw, 0, 1, 0);
    draw_planet();
    glPopMatrix();
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(30, (double)width / height, 1, 20);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(0, 0, 6.5, 0, 0, 0, 0, 1, 0);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key >= 'x' && key <= 'z')
        drawn[key - 'x'] = !drawn[key - 'x'];
    glutPostRedisplay();
}

static void special(int key, int x, int y)
{
    (void)x, (void)y;
    yaw += 10 * ((key == GLUT_KEY_RIGHT) - (key == GLUT_KEY_LEFT));
    pitch += 10 * ((key == GLUT_KEY_DOWN) - (key == GLUT_KEY_UP));
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(500, 500);
    glutCreateWindow("clip");
    glClearColor(0.05f, 0.05f, 0.08f, 1);
    glLightfv(GL_LIGHT0, GL_POSITION, (float[]){1, 1.5f, 2, 0});
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
    glMaterialfv(GL_FRONT, GL_SPECULAR, (float[]){0.3f, 0.3f, 0.3f, 1});
    glMaterialf(GL_FRONT, GL_SHININESS, 24);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutSpecialFunc(special);
    glutMainLoop();
    return 0;
}
