/*
 * cubemap: a mirror ball and a mirror teapot in a room.
 *
 * The six images of a cube map are the room seen from its middle. Reflection map coordinates are the direction
 * in which the eye's ray leaves the surface, and a direction is what a cube map is asked with. With normal map
 * coordinates it is the surface's own direction, as diffuse light would be looked up.
 *
 *   n            reflection or normal map
 *   left right   turn the room
 *
 * GL 1.5, 2.11.4 "Generating Texture Coordinates", 3.8.6 "Cube Map Texture Selection".
 */
#include <GL/glut.h>

enum { SIZE = 64, FACES = 6 };

static GLenum mode = GL_REFLECTION_MAP;
static int angle;

/* A wall in its own color with a grid, and a lamp in the ceiling. */
static void make_texture(void)
{
    static const GLubyte color[FACES][3] = {{200, 90, 70},   {80, 150, 100}, {225, 225, 215},
                                            {110, 100, 90}, {90, 120, 190}, {210, 180, 90}};
    static GLubyte image[SIZE][SIZE][3];
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (int face = 0; face < FACES; face++) {
        for (int t = 0; t < SIZE; t++)
            for (int s = 0; s < SIZE; s++) {
                const int u = 2 * s - SIZE, v = 2 * t - SIZE;
                const int lamp = face == 2 && u * u + v * v < 600, line = t % 16 < 2 || s % 16 < 2;
                for (int c = 0; c < 3; c++)
                    image[t][s][c] = (GLubyte)(lamp ? 255 : line ? color[face][c] / 2 : color[face][c]);
            }
        glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + (GLenum)face, 0, GL_RGB, SIZE, SIZE, 0, GL_RGB, GL_UNSIGNED_BYTE, image);
    }
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
}

static void set_generation(void)
{
    for (GLenum i = 0; i < 3; i++) {
        glTexGeni(GL_S + i, GL_TEXTURE_GEN_MODE, (int)mode);
        glEnable(GL_TEXTURE_GEN_S + i);
    }
    glMatrixMode(GL_TEXTURE);
    glLoadIdentity();
    glRotatef((float)angle, 0, 1, 0);
    glMatrixMode(GL_MODELVIEW);
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    set_generation();
    glPushMatrix();
    glTranslatef(-1.2f, 0, 0);
    glutSolidSphere(0.95, 40, 30);
    glTranslatef(2.3f, 0, 0);
    glRotatef(25, 1, 1, 0);
    glutSolidTeapot(0.75);
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
    glTranslatef(0, 0, -5);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 'n')
        mode = mode == GL_REFLECTION_MAP ? GL_NORMAL_MAP : GL_REFLECTION_MAP;
    glutPostRedisplay();
}

static void special(int key, int x, int y)
{
    (void)x, (void)y;
    angle += key == GLUT_KEY_RIGHT ? 15 : key == GLUT_KEY_LEFT ? -15 : 0;
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(320, 200);
    glutCreateWindow("cubemap");
    glClearColor(0.20f, 0.22f, 0.26f, 1);
    glEnable(GL_NORMALIZE);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_TEXTURE_CUBE_MAP);
    make_texture();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutSpecialFunc(special);
    glutMainLoop();
    return 0;
}
