/*
 * pointp: a galaxy of points that shrink with distance.
 *
 * glPointParameter divides the size of a point by the square root of a polynomial in its distance from the
 * eye, and keeps it between two limits.
 *
 *   a       next attenuation: none, linear, quadratic
 *   m       least size 1 or 3
 *   left, right   turn
 *
 * GL 1.5, 3.3 "Points".
 */
#define GL_GLEXT_PROTOTYPES
#include <GL/glut.h>

#include <math.h>

enum { STARS = 1500, ARMS = 3 };

static const float attenuation[3][3] = {{1, 0, 0}, {0, 0.5f, 0}, {0, 0, 0.06f}};
static int chosen = 2, large;
static float angle = 20;

/* The same stars each time: 0 .. 1, from a linear congruence. */
static float next_random(unsigned *seed)
{
    *seed = *seed * 1103515245u + 12345u;
    return (float)(*seed >> 16 & 0x7fff) / 32767.0f;
}

static void draw_stars(void)
{
    unsigned seed = 1;

    glBegin(GL_POINTS);
    for (int i = 0; i < STARS; i++) {
        const float r = 0.15f + 3.2f * next_random(&seed), spread = 0.5f * (next_random(&seed) - 0.5f);
        const float turn = 6.2832f * (float)(i % ARMS) / ARMS + 1.1f * r + spread;
        glColor3f(0.6f + 0.4f * next_random(&seed), 0.75f, 1.1f - 0.2f * r);
        glVertex3f(r * cosf(turn), 0.25f * (next_random(&seed) - 0.5f), r * sinf(turn));
    }
    glEnd();
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, attenuation[chosen]);
    glPointParameterf(GL_POINT_SIZE_MIN, large ? 3 : 1);
    glPointParameterf(GL_POINT_SIZE_MAX, 12);
    glPointSize(chosen ? 8 : 3);
    glPushMatrix();
    glRotatef(angle, 0, 1, 0);
    draw_stars();
    glPopMatrix();
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(60, (double)width / height, 0.2, 40);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(0, 1.6, 4, 0, 0, 0, 0, 1, 0);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 'a')
        chosen = (chosen + 1) % 3;
    if (key == 'm')
        large = !large;
    glutPostRedisplay();
}

static void special(int key, int x, int y)
{
    (void)x, (void)y;
    angle += key == GLUT_KEY_LEFT ? -10 : key == GLUT_KEY_RIGHT ? 10 : 0;
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(400, 300);
    glutCreateWindow("pointp");
    glClearColor(0.02f, 0.02f, 0.06f, 1);
    glEnable(GL_DEPTH_TEST);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutSpecialFunc(special);
    glutMainLoop();
    return 0;
}
