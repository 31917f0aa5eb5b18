/*
 * texgen: contour lines on a teapot, by coordinates that GL generates.
 *
 * A one-dimensional texture with one bright texel is repeated along s, the distance from a plane. A plane of
 * object coordinates turns with the teapot; one of eye coordinates stays where it is, and the teapot swims
 * through its contours. A sphere map takes s from the direction of reflection.
 *
 *   o e s        object plane, eye plane, sphere map
 *   left right   turn the teapot
 *
 * GL 1.5, 2.11.4 "Generating Texture Coordinates".
 */
#include <GL/glut.h>

enum { SIZE = 32 };

static GLenum mode = GL_OBJECT_LINEAR;
static int angle;

static void make_texture(void)
{
    static GLubyte image[SIZE][3];
    for (int s = 0; s < SIZE; s++) {
        image[s][0] = (GLubyte)(s < 4 ? 255 : 70);
        image[s][1] = (GLubyte)(s < 4 ? 214 : 90 + 2 * s);
        image[s][2] = (GLubyte)(s < 4 ? 90 : 110 + 3 * s);
    }
    glTexImage1D(GL_TEXTURE_1D, 0, GL_RGB, SIZE, 0, GL_RGB, GL_UNSIGNED_BYTE, image);
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

static void set_generation(void)
{
    static const float plane[4] = {0.6f, 1.6f, 0, 0.5f};
    glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, (int)mode);
    if (mode == GL_OBJECT_LINEAR)
        glTexGenfv(GL_S, GL_OBJECT_PLANE, plane);
    else if (mode == GL_EYE_LINEAR)
        glTexGenfv(GL_S, GL_EYE_PLANE, plane);
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    set_generation();
    glPushMatrix();
    glRotatef(25, 1, 0, 0);
    glRotatef((float)angle, 0, 1, 0);
    glutSolidTeapot(1);
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
    glTranslatef(0, 0, -4.2f);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    mode = key == 'o' ? GL_OBJECT_LINEAR : key == 'e' ? GL_EYE_LINEAR : key == 's' ? GL_SPHERE_MAP : mode;
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
    glutInitWindowSize(320, 240);
    glutCreateWindow("texgen");
    glClearColor(0.10f, 0.11f, 0.14f, 1);
    glLightfv(GL_LIGHT0, GL_POSITION, (float[]){1, 2, 2, 0});
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (float[]){1, 1, 1, 1});
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_NORMALIZE);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_TEXTURE_1D);
    glEnable(GL_TEXTURE_GEN_S);
    make_texture();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutSpecialFunc(special);
    glutMainLoop();
    return 0;
}
