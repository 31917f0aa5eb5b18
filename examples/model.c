/*
 * model: what the modelview matrix does to a drawing.
 *
 * Four panels show the same house as a gray ghost, and as an outline after a transformation: translated,
 * rotated, scaled, and sheared by a matrix of our own. Each outline has its own stipple; the window is cut by
 * viewports.
 *
 *   + and -   more or less of each transformation, from none to all of it
 *
 * GL 1.5, 2.11 "Coordinate Transformations" and 3.4.2 "Other Line Segment Features" (width, stipple).
 */
#include <GL/glut.h>

static const GLushort stipples[4] = {0xffff, 0x00ff, 0x3f3f,
                                     0x1c47}; /* solid, long and short dashes, dash and dot */
static const float colors[4][3] = {
        {1, 0.75f, 0.3f}, {0.4f, 0.85f, 0.5f}, {0.4f, 0.7f, 1}, {0.95f, 0.5f, 0.75f}};
static float amount = 1; /* of each transformation, 0 to 1 */

static void transform(int panel)
{
    const float shear[16] = {1, 0, 0, 0, -1.2f * amount, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}; /* by columns */

    switch (panel) {
    case 0: glTranslatef(-0.8f * amount, -0.85f * amount, 0); break;
    case 1: glRotatef(130 * amount, 0, 0, 1); break;
    case 2: glScalef(1 + 0.5f * amount, 1 - 1.7f * amount, 1); break;
    case 3: glMultMatrixf(shear); break;
    }
}

static void draw_house(GLenum primitive)
{
    static const float corners[5][2] = {{0, 0}, {0.6f, 0}, {0.6f, 0.5f}, {0.3f, 0.8f}, {0, 0.5f}};

    glBegin(primitive);
    for (int i = 0; i < 5; i++)
        glVertex2fv(corners[i]);
    glEnd();
}

static void draw_door(void)
{
    static const float corners[4][2] = {{0.1f, 0}, {0.1f, 0.3f}, {0.27f, 0.3f}, {0.27f, 0}};

    glBegin(GL_LINE_STRIP);
    for (int i = 0; i < 4; i++)
        glVertex2fv(corners[i]);
    glEnd();
}

static void draw_axes(void)
{
    static const float ends[4][2] = {{-0.92f, 0}, {0.92f, 0}, {0, -0.92f}, {0, 0.92f}};

    glBegin(GL_LINES);
    for (int i = 0; i < 4; i++)
        glVertex2fv(ends[i]);
    glEnd();
}

static void draw_panel(int panel)
{
    glColor3f(0.20f, 0.22f, 0.27f);
    draw_house(GL_POLYGON);
    glColor3f(0.40f, 0.42f, 0.48f);
    draw_axes();
    glPushAttrib(GL_LINE_BIT | GL_CURRENT_BIT);
    glPushMatrix();
    glColor3fv(colors[panel]);
    glLineWidth(2);
    glLineStipple(1, stipples[panel]);
    glEnable(GL_LINE_STIPPLE);
    transform(panel);
    draw_house(GL_LINE_LOOP);
    draw_door();
    glPopMatrix();
    glPopAttrib();
}

static void display(void)
{
    const int width = glutGet(GLUT_WINDOW_WIDTH) / 2, height = glutGet(GLUT_WINDOW_HEIGHT) / 2;

    glClear(GL_COLOR_BUFFER_BIT);
    for (int panel = 0; panel < 4; panel++) {
        glViewport(panel % 2 * width, (1 - panel / 2) * height, width, height);
        draw_panel(panel);
    }
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    const double shorter = width < height ? width : height;

    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluOrtho2D(-width / shorter, width / shorter, -height / shorter, height / shorter);
    glMatrixMode(GL_MODELVIEW);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == '+' && amount < 1)
        amount += 0.25f;
    else if (key == '-' && amount > 0)
        amount -= 0.25f;
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB);
    glutInitWindowSize(500, 500);
    glutCreateWindow("model");
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
