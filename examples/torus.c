/*
 * torus: a ring of candy, compiled once and turned often.
 *
 * The torus is made of quad strips, its stripes from a color per vertex, and kept in a display list. Turning
 * it only changes the matrix: each key turns it about an axis of the screen, whatever its position.
 *
 *   x, X, y, Y, z, Z   turn by 15 degrees, and back
 *   i                  as at first
 *
 * GL 1.5, 5.4 "Display Lists" and 2.11.2 "Matrices".
 */
#include <GL/glut.h>
#include <math.h>

enum { TORUS = 1, SIDES = 24, RINGS = 120 };

static const float pi = 3.14159265f;
static GLfloat rotation[16];

/* One vertex: `ring` along the torus, `side` around its tube. */
static void place(int ring, int side)
{
    const float u = 2 * pi * (float)ring / RINGS, v = 2 * pi * (float)side / SIDES;

    glNormal3f(cosf(u) * cosf(v), sinf(u) * cosf(v), sinf(v));
    glVertex3f(cosf(u) * (1 + 0.42f * cosf(v)), sinf(u) * (1 + 0.42f * cosf(v)), 0.42f * sinf(v));
}

/* The stripes wind around the tube. */
static void set_color(int ring, int side)
{
    if ((2 * ring + 5 * side) % 40 < 20)
        glColor3f(0.92f, 0.28f, 0.32f);
    else
        glColor3f(0.97f, 0.94f, 0.88f);
}

static void make_torus(void)
{
    glNewList(TORUS, GL_COMPILE);
    glShadeModel(GL_FLAT); /* a stripe ends where its quads end */
    for (int ring = 0; ring < RINGS; ring++) {
        glBegin(GL_QUAD_STRIP);
        for (int side = 0; side <= SIDES; side++) {
            set_color(ring, side);
            place(ring, side);
            place(ring + 1, side);
        }
        glEnd();
    }
    glShadeModel(GL_SMOOTH);
    glEndList();
}

static void turn(float degrees, float x, float y, float z)
{
    glPushMatrix();
    glLoadIdentity();
    glRotatef(degrees, x, y, z);
    glMultMatrixf(rotation);
    glGetFloatv(GL_MODELVIEW_MATRIX, rotation);
    glPopMatrix();
}

static void start(void)
{
    glPushMatrix();
    glLoadIdentity();
    glGetFloatv(GL_MODELVIEW_MATRIX, rotation);
    glPopMatrix();
    turn(-50, 1, 0, 0);
    turn(20, 0, 0, 1);
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glPushMatrix();
    glTranslatef(0, 0, -5.5f);
    glMultMatrixf(rotation);
    glCallList(TORUS);
    glPopMatrix();
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(32, (double)width / height, 1, 20);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    switch (key) {
    case 'x': turn(15, 1, 0, 0); break;
    case 'X': turn(-15, 1, 0, 0); break;
    case 'y': turn(15, 0, 1, 0); break;
    case 'Y': turn(-15, 0, 1, 0); break;
    case 'z': turn(15, 0, 0, 1); break;
    case 'Z': turn(-15, 0, 0, 1); break;
    case 'i': start(); break;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(320, 240);
    glutCreateWindow("torus");
    glClearColor(0.16f, 0.30f, 0.34f, 1);
    glLightfv(GL_LIGHT0, GL_POSITION, (float[]){-1, 1.5f, 2, 0});
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_COLOR_MATERIAL);
    glEnable(GL_DEPTH_TEST);
    make_torus();
    start();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
