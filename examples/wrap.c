/*
 * wrap: what lies beyond the edge of a texture.
 *
 * Five squares show the same image with coordinates from -1 to 2, and with the five wrap modes: repeat,
 * mirrored repeat, clamp, clamp to edge, clamp to border. The border is orange.
 *
 *   l   nearest or linear: GL_CLAMP mixes the border in only with linear
 *   t   the modes for t; s repeats
 *
 * GL 1.5, 3.8.7 "Texture Wrap Modes".
 */
#include <GL/glut.h>

enum { SIZE = 8, MODES = 5 };

static const GLenum modes[MODES] = {GL_REPEAT, GL_MIRRORED_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER};
static int filter = GL_NEAREST, only_t;

/* An arrow, so that mirrors show. */
static void make_texture(void)
{
    static const char *const rows[SIZE] = {"...##...", "..####..", ".######.", "########",
                                           "...##...", "...##...", "...##...", "...####."};
    static GLubyte image[SIZE][SIZE][3];
    for (int t = 0; t < SIZE; t++)
        for (int s = 0; s < SIZE; s++) {
            const int arrow = rows[SIZE - 1 - t][s] == '#';
            image[t][s][0] = (GLubyte)(arrow ? 30 : 170 + 8 * s);
            image[t][s][1] = (GLubyte)(arrow ? 50 : 180 + 8 * t);
            image[t][s][2] = (GLubyte)(arrow ? 90 : 230);
        }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, SIZE, SIZE, 0, GL_RGB, GL_UNSIGNED_BYTE, image);
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, (float[]){1, 0.6f, 0.1f, 1});
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
}

static void square(float x, float y)
{
    glBegin(GL_QUADS);
    glTexCoord2f(-1, -1);
    glVertex2f(x, y);
    glTexCoord2f(2, -1);
    glVertex2f(x + 1, y);
    glTexCoord2f(2, 2);
    glVertex2f(x + 1, y + 1);
    glTexCoord2f(-1, 2);
    glVertex2f(x, y + 1);
    glEnd();
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    for (int i = 0; i < MODES; i++) {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, (int)modes[only_t ? 0 : i]);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, (int)modes[i]);
        square(0.1f + 1.1f * (float)(i % 3) + (i > 2 ? 0.55f : 0), i < 3 ? 1.2f : 0.1f);
    }
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluOrtho2D(0, 3.4, 0, 2.3);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 'l')
        filter = filter == GL_NEAREST ? GL_LINEAR : GL_NEAREST;
    if (key == 't')
        only_t = !only_t;
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB);
    glutInitWindowSize(340, 230);
    glutCreateWindow("wrap");
    glClearColor(0.15f, 0.16f, 0.18f, 1);
    glEnable(GL_TEXTURE_2D);
    make_texture();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
