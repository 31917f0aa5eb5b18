/*
 * mipmap: a floor whose every mipmap level has its own color.
 *
 * Which color a fragment gets shows which images it was filtered from: far away, where many texels fall into
 * one pixel, small images are taken. With a linear mipmap filter two neighbouring levels are mixed.
 *
 *   f     next minification filter
 *   + -   bias the level of detail
 *
 * GL 1.5, 3.8.8 "Texture Minification", 3.8.13 (GL_TEXTURE_LOD_BIAS).
 */
#include <GL/glut.h>

enum { SIZE = 64, LEVELS = 7 };

static const GLenum filters[] = {GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_NEAREST, GL_NEAREST_MIPMAP_LINEAR,
                                 GL_LINEAR_MIPMAP_LINEAR,   GL_NEAREST,               GL_LINEAR};
static int filter = 0;
static float bias;

static void make_texture(void)
{
    static const GLubyte color[LEVELS][3] = {{230, 80, 60},  {240, 170, 50}, {240, 230, 90}, {110, 190, 90},
                                             {70, 150, 210}, {120, 90, 190}, {230, 230, 235}};
    static GLubyte image[SIZE * SIZE][3];
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (int level = 0, size = SIZE; level < LEVELS; level++, size /= 2) {
        for (int i = 0; i < size * size; i++) {
            const int dark = (i / size / 4 + i % size / 4) % 2 * 40;
            for (int c = 0; c < 3; c++)
                image[i][c] = (GLubyte)(color[level][c] - dark);
        }
        glTexImage2D(GL_TEXTURE_2D, level, GL_RGB, size, size, 0, GL_RGB, GL_UNSIGNED_BYTE, image);
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
}

static void display(void)
{
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, (int)filters[filter]);
    glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, bias);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glBegin(GL_QUADS);
    glTexCoord2f(0, 0);
    glVertex3f(-6, 0, 2);
    glTexCoord2f(8, 0);
    glVertex3f(6, 0, 2);
    glTexCoord2f(8, 60);
    glVertex3f(6, 0, -88);
    glTexCoord2f(0, 60);
    glVertex3f(-6, 0, -88);
    glEnd();
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(45, (double)width / height, 0.5, 120);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(0, 2.2, 4, 0, 0, -6, 0, 1, 0);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 'f')
        filter = (filter + 1) % (int)(sizeof filters / sizeof filters[0]);
    bias += key == '+' ? 0.25f : key == '-' ? -0.25f : 0;
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(320, 240);
    glutCreateWindow("mipmap");
    glClearColor(0.75f, 0.82f, 0.88f, 1);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_TEXTURE_2D);
    make_texture();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
