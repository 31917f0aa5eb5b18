/*
 * texsub: a part of a texture replaced.
 *
 * glTexSubImage2D writes a smaller image into the one that is there, at any offset.
 *
 *   s   put one more patch into the checkers
 *   r   the whole image again
 *
 * GL 1.5, 3.8.2 "Alternate Texture Image Specification Commands".
 */
#include <GL/glut.h>

enum { SIZE = 64, PATCH = 16 };

static int patches;

static void checkers(GLubyte (*image)[3], int size, int square, const GLubyte light[3], const GLubyte dark[3])
{
    for (int i = 0; i < size * size; i++) {
        const GLubyte *color = (i / size / square + i % size / square) % 2 ? light : dark;
        for (int c = 0; c < 3; c++)
            image[i][c] = color[c];
    }
}

static void make_texture(void)
{
    static const GLubyte light[3] = {240, 240, 232}, dark[3] = {60, 66, 84};
    static GLubyte image[SIZE * SIZE][3];
    checkers(image, SIZE, 8, light, dark);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, SIZE, SIZE, 0, GL_RGB, GL_UNSIGNED_BYTE, image);
}

static void put_patch(int number)
{
    const GLubyte light[3] = {(GLubyte)(255 - 30 * number), (GLubyte)(120 + 30 * number), 60}, dark[3] = {90, 20, 20};
    GLubyte image[PATCH * PATCH][3];
    checkers(image, PATCH, 2, light, dark);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 4 + 14 * number % 44, 6 + 18 * number % 40, PATCH, PATCH, GL_RGB, GL_UNSIGNED_BYTE,
                    image);
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glBegin(GL_QUADS);
    glTexCoord2f(0, 0);
    glVertex3f(-1.4f, -1, 0.8f);
    glTexCoord2f(1, 0);
    glVertex3f(1.4f, -1, -0.8f);
    glTexCoord2f(1, 1);
    glVertex3f(1.4f, 1, -0.8f);
    glTexCoord2f(0, 1);
    glVertex3f(-1.4f, 1, 0.8f);
    glEnd();
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
    glTranslatef(0, 0, -3.4f);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 's')
        put_patch(patches++);
    if (key == 'r') {
        make_texture();
        patches = 0;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(320, 240);
    glutCreateWindow("texsub");
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    make_texture();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
