/*
 * bezcurve: a curve pulled by its control points.
 *
 * A one-dimensional evaluator turns five control points, and five colors, into a Bezier curve of degree four.
 * The grid cuts the curve into line segments; glEvalMesh1 draws them all at once.
 *
 *   left button   drag a control point
 *   + and -       more or fewer segments
 *
 * GL 1.5, 5.1 "Evaluators".
 */
#include <GL/glut.h>

enum { ORDER = 5 };

static float points[ORDER][3] = {
        {-0.85f, -0.6f, 0}, {-0.7f, 0.75f, 0}, {0.05f, -0.9f, 0}, {0.3f, 0.85f, 0}, {0.85f, 0.2f, 0}};
static const float colors[ORDER][4] = {{0.95f, 0.3f, 0.2f, 1},
                                       {0.95f, 0.8f, 0.2f, 1},
                                       {0.3f, 0.9f, 0.4f, 1},
                                       {0.2f, 0.7f, 0.95f, 1},
                                       {0.6f, 0.4f, 0.95f, 1}};
static int segments = 30;
static int held = -1; /* the control point under the mouse */

static void draw_control_polygon(void)
{
    glEnable(GL_LINE_STIPPLE);
    glLineWidth(1);
    glColor3f(0.5f, 0.52f, 0.57f);
    glBegin(GL_LINE_STRIP);
    for (int i = 0; i < ORDER; i++)
        glVertex3fv(points[i]);
    glEnd();
    glDisable(GL_LINE_STIPPLE);
    glPointSize(9);
    glBegin(GL_POINTS);
    for (int i = 0; i < ORDER; i++) {
        glColor4fv(colors[i]);
        glVertex3fv(points[i]);
    }
    glEnd();
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT);
    draw_control_polygon();
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, ORDER, points[0]);
    glMap1f(GL_MAP1_COLOR_4, 0, 1, 4, ORDER, colors[0]);
    glMapGrid1f(segments, 0, 1);
    glLineWidth(3);
    glEvalMesh1(GL_LINE, 0, segments);
    glPointSize(3);
    glEvalMesh1(GL_POINT, 0, segments);
    glutSwapBuffers();
}

/* Window pixels, y down, to the square from -1 to 1. */
static void to_plane(int x, int y, float place[2])
{
    place[0] = 2 * ((float)x + 0.5f) / (float)glutGet(GLUT_WINDOW_WIDTH) - 1;
    place[1] = 1 - 2 * ((float)y + 0.5f) / (float)glutGet(GLUT_WINDOW_HEIGHT);
}

static void mouse(int button, int state, int x, int y)
{
    float place[2];

    held = -1;
    if (button != GLUT_LEFT_BUTTON || state != GLUT_DOWN)
        return;
    to_plane(x, y, place);
    for (int i = 0; i < ORDER; i++) {
        const float dx = points[i][0] - place[0], dy = points[i][1] - place[1];
        if (dx * dx + dy * dy < 0.01f)
            held = i;
    }
}

static void motion(int x, int y)
{
    if (held < 0)
        return;
    to_plane(x, y, points[held]);
    glutPostRedisplay();
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == '+' && segments < 100)
        segments++;
    if (key == '-' && segments > 1)
        segments--;
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB);
    glutInitWindowSize(500, 500);
    glutCreateWindow("bezcurve");
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glLineStipple(2, 0x5555);
    glEnable(GL_MAP1_VERTEX_3);
    glEnable(GL_MAP1_COLOR_4);
    glutDisplayFunc(display);
    glutMouseFunc(mouse);
    glutMotionFunc(motion);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
