/*
 * tesswind: what is inside? Winding rules.
 *
 * Contours that overlap divide the plane into regions; the winding number of a region is how often the
 * contours run around it. The rule says for which numbers a region is inside. Four drawings under the current
 * rule: nested squares running the same way, nested squares of which the middle one runs the other way,
 * overlapping triangles, and a spiral that crosses itself.
 *
 *   w   next rule: odd, nonzero, positive, negative, at least two in absolute value
 *
 * GLU 1.3, 5.4 "Tessellation Properties".
 */
#include <GL/glut.h>
#include <stdlib.h>

enum { RULES = 5, DRAWINGS = 4, MAX_MADE = 256 };

static const GLenum rules[RULES] = {GLU_TESS_WINDING_ODD, GLU_TESS_WINDING_NONZERO, GLU_TESS_WINDING_POSITIVE,
                                    GLU_TESS_WINDING_NEGATIVE, GLU_TESS_WINDING_ABS_GEQ_TWO};
static int rule;
static GLUtesselator *tess;
static GLdouble made[MAX_MADE][3]; /* vertices at crossings */
static int made_count;

static void combine(GLdouble place[3], void *neighbors[4], GLfloat weight[4], void **result)
{
    GLdouble *v = made[made_count++ % MAX_MADE];

    (void)neighbors, (void)weight;
    for (int i = 0; i < 3; i++)
        v[i] = place[i];
    *result = v;
}

static void fail(GLenum error)
{
    (void)error;
    exit(1);
}

static void contour(GLdouble (*v)[3], int n)
{
    gluTessBeginContour(tess);
    for (int i = 0; i < n; i++)
        gluTessVertex(tess, v[i], v[i]);
    gluTessEndContour(tess);
}

/* Counterclockwise when direction is 1, clockwise when it is -1. */
static void square(GLdouble (*v)[3], double half, double direction)
{
    const double x[4] = {-half, half, half, -half}, y[4] = {-half, -half, half, half};

    for (int i = 0; i < 4; i++) {
        v[i][0] = x[i];
        v[i][1] = direction * y[i];
        v[i][2] = 0;
    }
    contour(v, 4);
}

static void squares(double middle)
{
    static GLdouble v[3][4][3];

    square(v[0], 0.9, 1);
    square(v[1], 0.6, middle);
    square(v[2], 0.3, 1);
}

static void triangles(void)
{
    static GLdouble a[3][3] = {{-0.9, -0.8, 0}, {0.7, -0.5, 0}, {-0.1, 0.9, 0}},
                    b[3][3] = {{-0.7, 0.5, 0}, {0.9, 0.8, 0}, {0.2, -0.9, 0}},
                    c[3][3] = {{-0.5, -0.2, 0}, {0, 0.6, 0}, {0.5, -0.2, 0}};

    contour(a, 3);
    contour(b, 3);
    contour(c, 3);
}

static void spiral(void)
{
    static GLdouble v[9][3] = {{0.9, -0.9, 0},  {0.9, 0.9, 0},   {-0.8, 0.8, 0},
                               {-0.7, -0.6, 0}, {0.6, -0.5, 0},  {0.5, 0.5, 0},
                               {-0.4, 0.3, 0},  {-0.3, -0.8, 0}, {0.1, -0.2, 0}};

    contour(v, 9);
}

static void draw(int drawing)
{
    gluTessBeginPolygon(tess, NULL);
    switch (drawing) {
    case 0: squares(1); break;
    case 1: squares(-1); break;
    case 2: triangles(); break;
    case 3: spiral(); break;
    }
    gluTessEndPolygon(tess);
}

static void display(void)
{
    made_count = 0;
    glClear(GL_COLOR_BUFFER_BIT);
    for (int i = 0; i < DRAWINGS; i++) {
        glPushMatrix();
        glTranslatef(i % 2 ? 1.05f : -1.05f, i < 2 ? 1.05f : -1.05f, 0);
        gluTessProperty(tess, GLU_TESS_WINDING_RULE, rules[rule]);
        gluTessProperty(tess, GLU_TESS_BOUNDARY_ONLY, GL_FALSE);
        glColor3f(0.25f, 0.45f + 0.1f * (float)i, 0.7f - 0.12f * (float)i);
        draw(i);
        gluTessProperty(tess, GLU_TESS_BOUNDARY_ONLY, GL_TRUE);
        glColor3f(0.95f, 0.9f, 0.6f);
        draw(i);
        glPopMatrix();
    }
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluOrtho2D(-2.1, 2.1, -2.1, 2.1);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 'w')
        rule = (rule + 1) % RULES;
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB);
    glutInitWindowSize(500, 500);
    glutCreateWindow("tesswind");
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glLineWidth(2);
    tess = gluNewTess();
    gluTessCallback(tess, GLU_TESS_BEGIN, (_GLUfuncptr)glBegin);
    gluTessCallback(tess, GLU_TESS_END, (_GLUfuncptr)glEnd);
    gluTessCallback(tess, GLU_TESS_VERTEX, (_GLUfuncptr)glVertex3dv);
    gluTessCallback(tess, GLU_TESS_COMBINE, (_GLUfuncptr)combine);
    gluTessCallback(tess, GLU_TESS_ERROR, (_GLUfuncptr)fail);
    gluTessNormal(tess, 0, 0, 1);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
