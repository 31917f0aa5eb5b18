/*
 * texprox: will a texture of this size be taken?
 *
 * A proxy texture has no image: glTexImage2D on it only checks, and its width is 0 afterwards if the answer is
 * no. Each bar is a power of two, green where a square RGBA texture of that size would be taken.
 *
 *   3   cubes of texels instead
 *
 * GL 1.5, 3.8.11 "Texture State and Proxy State".
 */
#include <GL/glut.h>

enum { POWERS = 20 };

static int cubes;

static int is_taken(int size)
{
    const GLenum proxy = cubes ? GL_PROXY_TEXTURE_3D : GL_PROXY_TEXTURE_2D;
    int width = 0;
    if (cubes)
        glTexImage3D(proxy, 0, GL_RGBA8, size, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    else
        glTexImage2D(proxy, 0, GL_RGBA8, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    glGetTexLevelParameteriv(proxy, 0, GL_TEXTURE_WIDTH, &width);
    while (glGetError() != GL_NO_ERROR) /* a size beyond all limits may be an error */
        width = 0;
    return width == size;
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT);
    for (int i = 0; i < POWERS; i++) {
        if (is_taken(1 << i))
            glColor3f(0.30f, 0.70f, 0.35f);
        else
            glColor3f(0.75f, 0.25f, 0.20f);
        glRectf((float)i + 0.1f, 0.5f, (float)i + 0.9f, 1 + (float)i);
    }
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluOrtho2D(0, POWERS, 0, POWERS + 1);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == '3')
        cubes = !cubes;
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB);
    glutInitWindowSize(320, 240);
    glutCreateWindow("texprox");
    glClearColor(0.94f, 0.94f, 0.92f, 1);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
