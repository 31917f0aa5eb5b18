/*
 * depthcue: a knot of wire that one can see the front of.
 *
 * A wire has no shading and hides little; only its color can tell near from far. Linear fog in the color of
 * the background fades it from the front of the knot to its back.
 *
 *   arrows   turn
 *   f        without fog
 *
 * GL 1.5, 3.10 "Fog" and 3.4 "Line Segments".
 */
#include <GL/glut.h>
#include <math.h>

enum { STEPS = 240, WIRES = 6 };

static const float distance = 6, radius = 1.7f;
static int pitch = 25, yaw = 20; /* degrees */
static GLboolean fog = GL_TRUE;

/* A knot that goes three times around the axis while it goes five times around the tube. */
static void place(float t, float around)
{
    const float ring = 1.1f + 0.4f * cosf(5 * t + around);

    glVertex3f(ring * cosf(3 * t), ring * sinf(3 * t), 0.4f * sinf(5 * t + around));
}

static void draw_knot(void)
{
    for (int wire = 0; wire < WIRES; wire++) {
        glColor3f(0.95f, 0.55f + 0.07f * (float)wire, 0.25f + 0.08f * (float)wire);
        glBegin(GL_LINE_LOOP);
        for (int i = 0; i < STEPS; i++)
            place(6.2831853f * (float)i / STEPS, 0.12f * (float)wire);
        glEnd();
    }
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    if (fog)
        glEnable(GL_FOG);
    else
        glDisable(GL_FOG);
    glPushMatrix();
    glRotatef((float)pitch, 1, 0, 0);
    glRotatef((float)yaw, 0, 1, 0);
    draw_knot();
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
    glTranslatef(0, 0, -distance);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 'f')
        fog = !fog;
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
    const float background[4] = {0.05f, 0.06f, 0.10f, 1};

    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(320, 240);
    glutCreateWindow("depthcue");
    glClearColor(background[0], background[1], background[2], 1);
    glFogfv(GL_FOG_COLOR, background);
    glFogi(GL_FOG_MODE, GL_LINEAR);
    glFogf(GL_FOG_START, distance - 0.8f * radius);
    glFogf(GL_FOG_END, distance + radius);
    glHint(GL_FOG_HINT, GL_NICEST);
    glLineWidth(2);
    glEnable(GL_DEPTH_TEST);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutSpecialFunc(special);
    glutMainLoop();
    return 0;
}
