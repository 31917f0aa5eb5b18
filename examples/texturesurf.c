/*
 * texturesurf: a picture on a curved surface, by evaluators.
 *
 * One evaluator makes the vertices of a Bezier surface, another the texture coordinates; glEvalMesh2 runs both.
 *
 *   arrows   turn the surface
 *   w        curved texture coordinates
 *
 * GL 1.5, 5.1 "Evaluators" (GL_MAP2_TEXTURE_COORD_2).
 */
#include <GL/glut.h>

enum { SIZE = 64 };

static int pitch = -35, yaw = 25, curved;

static const float points[4][4][3] = {
        {{-1.5f, -1.5f, 1.5f}, {-0.5f, -1.5f, 0.5f}, {0.5f, -1.5f, -0.5f}, {1.5f, -1.5f, 0.8f}},
        {{-1.5f, -0.5f, 0.4f}, {-0.5f, -0.5f, 1.8f}, {0.5f, -0.5f, 0}, {1.5f, -0.5f, -0.6f}},
        {{-1.5f, 0.5f, 1.2f}, {-0.5f, 0.5f, 0}, {0.5f, 0.5f, 1.4f}, {1.5f, 0.5f, 0.6f}},
        {{-1.5f, 1.5f, -0.8f}, {-0.5f, 1.5f, -0.4f}, {0.5f, 1.5f, 0}, {1.5f, 1.5f, -0.5f}}};

/* Rings and spokes of color. */
static void make_texture(void)
{
    static GLubyte image[SIZE][SIZE][3];
    for (int t = 0; t < SIZE; t++)
        for (int s = 0; s < SIZE; s++) {
            const int x = 2 * s - SIZE, y = 2 * t - SIZE, ring = (x * x + y * y) / 256 % 2;
            image[t][s][0] = (GLubyte)(ring ? 235 : 4 * s);
            image[t][s][1] = (GLubyte)(ring ? 225 : 4 * t);
            image[t][s][2] = (GLubyte)(ring ? 205 : 190);
        }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, SIZE, SIZE, 0, GL_RGB, GL_UNSIGNED_BYTE, image);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
}

static void set_coordinates(void)
{
    static const float straight[2][2][2] = {{{0, 0}, {0, 1}}, {{1, 0}, {1, 1}}};
    static const float bent[3][2][2] = {{{0, 0}, {0, 1}}, {{0.1f, 0.4f}, {0.9f, 0.6f}}, {{1, 0}, {1, 1}}};
    if (curved)
        glMap2f(GL_MAP2_TEXTURE_COORD_2, 0, 1, 2, 2, 0, 1, 4, 3, &bent[0][0][0]);
    else
        glMap2f(GL_MAP2_TEXTURE_COORD_2, 0, 1, 2, 2, 0, 1, 4, 2, &straight[0][0][0]);
}

static void display(void)
{
    set_coordinates();
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glPushMatrix();
    glRotatef((float)pitch, 1, 0, 0);
    glRotatef((float)yaw, 0, 0, 1);
    glEvalMesh2(GL_FILL, 0, 20, 0, 20);
    glPopMatrix();
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(40, (double)width / height, 1, 20);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0, 0, -6);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 'w')
        curved = !curved;
    glutPostRedisplay();
}

static void special(int key, int x, int y)
{
    (void)x, (void)y;
    pitch += key == GLUT_KEY_UP ? 15 : key == GLUT_KEY_DOWN ? -15 : 0;
    yaw += key == GLUT_KEY_RIGHT ? 15 : key == GLUT_KEY_LEFT ? -15 : 0;
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(320, 240);
    glutCreateWindow("texturesurf");
    glClearColor(0.14f, 0.15f, 0.19f, 1);
    glMap2f(GL_MAP2_VERTEX_3, 0, 1, 3, 4, 0, 1, 12, 4, &points[0][0][0]);
    glMapGrid2f(20, 0, 1, 20, 0, 1);
    glEnable(GL_MAP2_VERTEX_3);
    glEnable(GL_MAP2_TEXTURE_COORD_2);
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_DEPTH_TEST);
    make_texture();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutSpecialFunc(special);
    glutMainLoop();
    return 0;
}
