/*
 * texbind: two texture objects, bound in turn.
 *
 * Each object keeps its image and its filters, so that changing textures is one command. The walls of a corner
 * take bricks, the floor takes tiles.
 *
 *   x   exchange the two
 *
 * GL 1.5, 3.8.12 "Texture Objects".
 */
#include <GL/glut.h>

enum { SIZE = 32 };

static GLuint names[2];
static int exchanged;

static void set_texel(GLubyte texel[3], int r, int g, int b)
{
    texel[0] = (GLubyte)r;
    texel[1] = (GLubyte)g;
    texel[2] = (GLubyte)b;
}

static void make_bricks(void)
{
    static GLubyte image[SIZE][SIZE][3];
    for (int t = 0; t < SIZE; t++)
        for (int s = 0; s < SIZE; s++) {
            const int row = t / 8, along = (s + row % 2 * 8) % 16;
            if (t % 8 == 0 || along == 0)
                set_texel(image[t][s], 190, 184, 172);
            else
                set_texel(image[t][s], 150 + (s * 7 + t * 3) % 30, 62 + (s * 5 + t) % 16, 48);
        }
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, SIZE, SIZE, 0, GL_RGB, GL_UNSIGNED_BYTE, image);
}

static void make_tiles(void)
{
    static GLubyte image[SIZE][SIZE][3];
    for (int t = 0; t < SIZE; t++)
        for (int s = 0; s < SIZE; s++) {
            const int u = s % 16 - 8, v = t % 16 - 8, inside = (u < 0 ? -u : u) + (v < 0 ? -v : v) < 6;
            if (inside)
                set_texel(image[t][s], 40, 96, 120);
            else
                set_texel(image[t][s], 226, 222, 210);
        }
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, SIZE, SIZE, 0, GL_RGB, GL_UNSIGNED_BYTE, image);
}

static void make_textures(void)
{
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glGenTextures(2, names);
    for (int i = 0; i < 2; i++) {
        glBindTexture(GL_TEXTURE_2D, names[i]);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, i == 0 ? GL_NEAREST : GL_LINEAR);
        if (i == 0)
            make_bricks();
        else
            make_tiles();
    }
}

/* A parallelogram: a corner and two edges, with the texture `repeat` times along each. */
static void wall(const float corner[3], const float along[3], const float up[3], float repeat)
{
    static const int order[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    glBegin(GL_QUADS);
    for (int i = 0; i < 4; i++) {
        const float s = (float)order[i][0], t = (float)order[i][1];
        glTexCoord2f(s * repeat, t * repeat);
        glVertex3f(corner[0] + s * along[0] + t * up[0], corner[1] + s * along[1] + t * up[1],
                   corner[2] + s * along[2] + t * up[2]);
    }
    glEnd();
}

static void display(void)
{
    static const float x[3] = {3, 0, 0}, y[3] = {0, 2, 0}, z[3] = {0, 0, 3}, back[3] = {0, 0, -3}, origin[3] = {0, 0, 0},
                       front[3] = {0, 0, 3};
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glBindTexture(GL_TEXTURE_2D, names[exchanged]);
    glColor3f(1, 1, 1);
    wall(origin, x, y, 2);
    glColor3f(0.72f, 0.72f, 0.76f);
    wall(front, back, y, 2);
    glBindTexture(GL_TEXTURE_2D, names[!exchanged]);
    glColor3f(0.95f, 0.95f, 0.92f);
    wall(origin, z, x, 3);
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
    gluLookAt(5.2, 3.2, 5.0, 1.1, 0.7, 1.1, 0, 1, 0);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 'x')
        exchanged = !exchanged;
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(320, 240);
    glutCreateWindow("texbind");
    glClearColor(0.12f, 0.13f, 0.16f, 1);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_TEXTURE_2D);
    make_textures();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
