/*
 * smooth: one triangle, three colors.
 *
 * With smooth shading the color of a fragment is interpolated between the three vertices. With flat shading
 * the whole triangle takes the color of one, its provoking vertex, which for a triangle is the last.
 *
 *   f   flat or smooth
 *   r   the next vertex comes last (watch it in flat shading)
 *
 * GL 1.5, 2.14.7 "Flatshading" and 3.5.1 "Basic Polygon Rasterization".
 */
#include <GL/glut.h>

static const struct {
    float color[3], position[2];
} corners[3] = {
        {{0.95f, 0.25f, 0.20f}, {-0.85f, -0.70f}},
        {{0.20f, 0.80f, 0.35f}, {0.85f, -0.70f}},
        {{0.20f, 0.40f, 0.95f}, {0, 0.77f}},
};

static GLboolean flat;
static int first;

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT);
    glShadeModel(flat ? GL_FLAT : GL_SMOOTH);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 3; i++) {
        const int corner = (first + i) % 3;
        glColor3fv(corners[corner].color);
        glVertex2fv(corners[corner].position);
    }
    glEnd();
    glFlush();
}

static void reshape(int width, int height)
{
    const double shorter = width < height ? width : height;

    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluOrtho2D(-width / shorter, width / shorter, -height / shorter, height / shorter);
    glMatrixMode(GL_MODELVIEW);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 'f')
        flat = !flat;
    else if (key == 'r')
        first = (first + 1) % 3;
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_SINGLE | GLUT_RGB);
    glutInitWindowSize(500, 500);
    glutCreateWindow("smooth");
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
