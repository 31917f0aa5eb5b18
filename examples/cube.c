/*
 * cube: the color cube, from vertex arrays.
 *
 * Eight vertices, each with its place as its color, and twenty-four indices make six faces. The vertex behind
 * each corner is given once, and shared by three faces. The faces that look away are culled, so no depth test
 * is needed.
 *
 *   arrows    turn the cube
 *   x, y, z   stretch it along its own axis, through 1, 0.5 and 1.5
 *
 * GL 1.5, 2.8 "Vertex Arrays", 2.11.2 "Matrices" and 3.5.1 (culling).
 */
#include <GL/glut.h>

/* Corner i is at the bits of i: x is bit 0, y bit 1, z bit 2. */
static const float colors[8][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                                   {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
static const float positions[8][3] = {{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1},
                                      {-1, -1, 1},  {1, -1, 1},  {-1, 1, 1},  {1, 1, 1}};

/* Counter-clockwise when seen from outside. */
static const GLubyte faces[24] = {0, 4, 6, 2, 1, 3, 7, 5, 0, 1, 5, 4, 2, 6, 7, 3, 0, 2, 3, 1, 4, 5, 7, 6};

static int pitch = 28, yaw = -35; /* degrees */
static const float sizes[3] = {1, 0.5f, 1.5f};
static int stretch[3]; /* along x, y, z: which of the sizes */

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT);
    glPushMatrix();
    glRotatef((float)pitch, 1, 0, 0);
    glRotatef((float)yaw, 0, 1, 0);
    glScalef(sizes[stretch[0]], sizes[stretch[1]], sizes[stretch[2]]);
    glDrawElements(GL_QUADS, 24, GL_UNSIGNED_BYTE, faces);
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
    gluLookAt(0, 0, 7.5, 0, 0, 0, 0, 1, 0);
}

static void special(int key, int x, int y)
{
    (void)x, (void)y;
    yaw += 10 * ((key == GLUT_KEY_RIGHT) - (key == GLUT_KEY_LEFT));
    pitch += 10 * ((key == GLUT_KEY_DOWN) - (key == GLUT_KEY_UP));
    glutPostRedisplay();
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key >= 'x' && key <= 'z')
        stretch[key - 'x'] = (stretch[key - 'x'] + 1) % 3;
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB);
    glutInitWindowSize(500, 500);
    glutCreateWindow("cube");
    glClearColor(0.22f, 0.23f, 0.26f, 1);
    glEnable(GL_CULL_FACE);
    glEnableClientState(GL_COLOR_ARRAY);
    glEnableClientState(GL_VERTEX_ARRAY);
    glColorPointer(3, GL_FLOAT, 0, colors);
    glVertexPointer(3, GL_FLOAT, 0, positions);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutSpecialFunc(special);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
