/*
 * trim: windows cut out of a NURBS surface.
 *
 * Trimming curves run in the surface's parameter space: what lies to their left stays. The outer border runs
 * counterclockwise; a keyhole, half a straight-sided polyline and half a NURBS curve, and a diamond run
 * clockwise and become holes.
 *
 *   1 2   keyhole, diamond on and off
 *   o     filled or outlined patches
 *
 * GL 1.5, 5.1 "Evaluators"; GLU 1.3, chapter 7.
 */
#include <GL/glut.h>

enum { ORDER = 4 };

static GLfloat knots[2 * ORDER] = {0, 0, 0, 0, 1, 1, 1, 1};
static GLfloat points[ORDER][ORDER][3];
static GLUnurbsObj *nurbs;
static GLboolean keyhole = GL_TRUE, diamond = GL_TRUE, outlined;

static void trim_border(void)
{
    static GLfloat border[5][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};

    gluBeginTrim(nurbs);
    gluPwlCurve(nurbs, 5, border[0], 2, GLU_MAP1_TRIM_2);
    gluEndTrim(nurbs);
}

static void trim_keyhole(void)
{
    static GLfloat arch[ORDER][2] = {{0.2f, 0.5f}, {0.1f, 0.95f}, {0.6f, 0.95f}, {0.5f, 0.5f}};
    static GLfloat slot[4][2] = {{0.5f, 0.5f}, {0.42f, 0.15f}, {0.28f, 0.15f}, {0.2f, 0.5f}};

    gluBeginTrim(nurbs);
    gluNurbsCurve(nurbs, 2 * ORDER, knots, 2, arch[0], ORDER, GLU_MAP1_TRIM_2);
    gluPwlCurve(nurbs, 4, slot[0], 2, GLU_MAP1_TRIM_2);
    gluEndTrim(nurbs);
}

static void trim_diamond(void)
{
    static GLfloat corners[5][2] = {{0.77f, 0.2f}, {0.64f, 0.4f}, {0.77f, 0.6f}, {0.9f, 0.4f}, {0.77f, 0.2f}};

    gluBeginTrim(nurbs);
    gluPwlCurve(nurbs, 5, corners[0], 2, GLU_MAP1_TRIM_2);
    gluEndTrim(nurbs);
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gluNurbsProperty(nurbs, GLU_DISPLAY_MODE, outlined ? (float)GLU_OUTLINE_PATCH : (float)GLU_FILL);
    gluBeginSurface(nurbs);
    gluNurbsSurface(nurbs, 2 * ORDER, knots, 2 * ORDER, knots, ORDER * 3, 3, points[0][0], ORDER, ORDER,
                    GL_MAP2_VERTEX_3);
    trim_border();
    if (keyhole)
        trim_keyhole();
    if (diamond)
        trim_diamond();
    gluEndSurface(nurbs);
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(42, (double)width / height, 1, 30);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(2, -4, 8, 0, 0.2, 0, 0, 1, 0);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    switch (key) {
    case '1': keyhole = !keyhole; break;
    case '2': diamond = !diamond; break;
    case 'o': outlined = !outlined; break;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(500, 500);
    glutCreateWindow("trim");
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    for (int i = 0; i < ORDER; i++) {
        for (int j = 0; j < ORDER; j++) {
            points[i][j][0] = 1.8f * (float)i - 2.7f;
            points[i][j][1] = 1.8f * (float)j - 2.7f;
            points[i][j][2] = (i + j) % 2 ? 1.4f : -1.4f;
        }
    }
    nurbs = gluNewNurbsRenderer();
    gluNurbsProperty(nurbs, GLU_SAMPLING_TOLERANCE, 20);
    glLightfv(GL_LIGHT0, GL_POSITION, (float[]){-2, 2, 4, 0});
    glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, (float[]){0.35f, 0.65f, 0.45f, 1});
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, (float[]){0.7f, 0.7f, 0.7f, 1});
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 30);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_AUTO_NORMAL);
    glEnable(GL_NORMALIZE);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
