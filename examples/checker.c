/*
 * checker: one checkered texture on two squares, one of them leaning away.
 *
 * The image is made here, 16 by 16 squares of 4 by 4 texels. Texture coordinates from 0 to 3 repeat it three
 * times. With the nearest filter every fragment takes one texel; the linear filter mixes four.
 *
 *   l   nearest or linear
 *
 * GL 1.5, 3.8.1 "Texture Image Specification", 3.8.7 "Texture Wrap Modes".
 */
#include <GL/glut.h>

enum { SIZE = 64, SQUARE = 4 };

static int filter = GL_NEAREST;

static void make_texture(void)
{
    static GLubyte image[SIZE][SIZE][4];
    for (int t = 0; t < SIZE; t++)
        for (int s = 0; s < SIZE; s++) {
            const int light = (t / SQUARE + s / SQUARE) % 2;
            image[t][s][0] = (GLubyte)(light ? 244 : 40);
            image[t][s][1] = (GLubyte)(light ? 236 : 70);
            image[t][s][2] = (GLubyte)(light ? 214 : 110);
            image[t][s][3] = 255;
        }
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, SIZE, SIZE, 0, GL_RGBA, GL_UNSIGNED_BYTE, image);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
}

static void square(float x0, float z0, float x1, float z1)
{
    glBegin(GL_QUADS);
    glTexCoord2f(0, 0);
    glVertex3f(x0, -1, z0);
    glTexCoord2f(3, 0);
    glVertex3f(x1, -1, z1);
    glTexCoord2f(3, 3);
    glVertex3f(x1, 1, z1);
    glTexCoord2f(0, 3);
    glVertex3f(x0, 1, z0);
    glEnd();
}

static void display(void)
{
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_TEXTURE_2D);
    square(-2.1f, 0, -0.2f, 0);
    square(0.2f, 0, 1.9f, -1.7f);
    glDisable(GL_TEXTURE_2D);
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(45, (double)width / height, 1, 20);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0, 0, -3.6f);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 'l')
        filter = filter == GL_NEAREST ? GL_LINEAR : GL_NEAREST;
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(320, 240);
    glutCreateWindow("checker");
    glEnable(GL_DEPTH_TEST);
    make_texture();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
