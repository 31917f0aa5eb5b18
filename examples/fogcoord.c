/*
 * fogcoord: mist that lies in a valley.
 *
 * The fog coordinate of a vertex takes the place of its distance from the eye: here it is how far the vertex
 * lies below the mist's surface, so that the fog gathers in the hollows, near and far alike.
 *
 *   f       fog by coordinate, or by distance
 *   + -     the mist rises, falls
 *
 * GL 1.5, 2.7 "Vertex Specification", 3.10 "Fog".
 */
#define GL_GLEXT_PROTOTYPES
#include <GL/glut.h>

#include <math.h>

enum { STEPS = 48 };

static float surface = 0.35f;
static int by_coordinate = 1;

/* Height of the ground. */
static float height(float x, float z)
{
    return 0.5f * sinf(1.3f * x + 0.4f) * cosf(0.9f * z) + 0.3f * cosf(2.1f * x - 1.7f * z);
}

static void set_vertex(int i, int j)
{
    const float x = 8.0f * (float)i / STEPS - 4, z = 2 - 12.0f * (float)j / STEPS, y = height(x, z);
    const float step = 0.05f, dx = height(x + step, z) - height(x - step, z),
                dz = height(x, z + step) - height(x, z - step);

    glNormal3f(-dx, 2 * step, -dz);
    glColor3f(0.30f + 0.25f * y, 0.46f + 0.10f * y, 0.24f + 0.20f * y);
    glFogCoordf(y < surface ? surface - y : 0);
    glVertex3f(x, y, z);
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glFogi(GL_FOG_COORD_SRC, by_coordinate ? GL_FOG_COORD : GL_FRAGMENT_DEPTH);
    glFogf(GL_FOG_DENSITY, by_coordinate ? 2.2f : 0.18f);
    for (int j = 0; j < STEPS; j++) {
        glBegin(GL_TRIANGLE_STRIP);
        for (int i = 0; i <= STEPS; i++) {
            set_vertex(i, j + 1);
            set_vertex(i, j);
        }
        glEnd();
    }
    glutSwapBuffers();
}

static void reshape(int width, int height_)
{
    glViewport(0, 0, width, height_);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(40, (double)width / height_, 0.5, 40);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(0, 2.6, 5.5, 0, 0.2, -1, 0, 1, 0);
    glLightfv(GL_LIGHT0, GL_POSITION, (float[]){2, 3, 1, 0});
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 'f')
        by_coordinate = !by_coordinate;
    surface += key == '+' ? 0.1f : key == '-' ? -0.1f : 0;
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(320, 240);
    glutCreateWindow("fogcoord");
    glClearColor(0.72f, 0.80f, 0.90f, 1);
    glFogfv(GL_FOG_COLOR, (float[]){0.90f, 0.91f, 0.93f, 1});
    glFogi(GL_FOG_MODE, GL_EXP);
    glEnable(GL_FOG);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_NORMALIZE);
    glEnable(GL_COLOR_MATERIAL);
    glEnable(GL_DEPTH_TEST);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
