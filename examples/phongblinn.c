/*
 * phongblinn: two highlights of one light on the same floor and ball. Left Blinn's, which OpenGL has: how near the
 * normal is to the half vector between light and viewer, (n.h)^s. Right Phong's: how near the reflected light comes
 * to the viewer, (r.v)^s.
 *
 * The angle between r and v is about twice that between n and h, so Phong's highlight is the smaller one; with a
 * quarter of the shininess (key m) the two look alike on the ball. On the floor, seen at a grazing angle, they
 * cannot: Blinn's becomes long and narrow, as on a wet street, while Phong's stays round.
 *
 *   + and -    double or halve the shininess of both
 *   m          a quarter of the shininess for Phong's
 *
 * GL 1.5, 2.14.1 "Lighting"; extensions GL_APPLE_specular_vector, and GL_WIN_phong_shading so that no vertex is missed.
 */
#include <GL/glut.h>

#include <stdio.h>
#include <stdlib.h>

#ifndef GL_PHONG_WIN
#define GL_PHONG_WIN 0x80EA
#endif
#ifndef GL_LIGHT_MODEL_SPECULAR_VECTOR_APPLE
#define GL_LIGHT_MODEL_SPECULAR_VECTOR_APPLE 0x85B0
#endif

static float shininess = 64;
static int matched;

static void material(float r, float g, float b)
{
    const float color[4] = {r, g, b, 1};
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, color);
}

static void scene(void)
{
    glPushMatrix();
    gluLookAt(0, 1.1, 5, 0, 0.75, 0, 0, 1, 0);
    glLightfv(GL_LIGHT0, GL_POSITION, (float[]){0, 1.6f, -5, 1});
    glLightfv(GL_LIGHT1, GL_POSITION, (float[]){-3, 5, 4, 1});
    material(0.12f, 0.13f, 0.16f);
    glNormal3f(0, 1, 0);
    glBegin(GL_QUADS);
    glVertex3f(-4, 0, 4);
    glVertex3f(4, 0, 4);
    glVertex3f(4, 0, -8);
    glVertex3f(-4, 0, -8);
    glEnd();
    material(0.45f, 0.18f, 0.10f);
    glTranslatef(0, 1.35f, 0);
    glutSolidSphere(0.6, 32, 24);
    glPopMatrix();
}

static void half(int x, int width, int height, int reflection)
{
    glViewport(x, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(38, (double)width / height, 1, 30);
    glMatrixMode(GL_MODELVIEW);
    glLightModeli(GL_LIGHT_MODEL_SPECULAR_VECTOR_APPLE, reflection);
    glMaterialf(GL_FRONT, GL_SHININESS, reflection && matched ? shininess / 4 : shininess);
    scene();
}

static void display(void)
{
    const int width = glutGet(GLUT_WINDOW_WIDTH), height = glutGet(GLUT_WINDOW_HEIGHT);

    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    half(0, width / 2 - 2, height, GL_FALSE);
    half(width / 2 + 2, width - width / 2 - 2, height, GL_TRUE);
    glFlush();
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == '+' && shininess < 128)
        shininess *= 2;
    else if (key == '-' && shininess > 4)
        shininess /= 2;
    else if (key == 'm')
        matched = !matched;
    glutPostRedisplay();
}

static void init(void)
{
    const float light[4] = {0.9f, 0.9f, 0.8f, 1}, dim[4] = {0.5f, 0.5f, 0.5f, 1};

    glClearColor(0.05f, 0.06f, 0.09f, 1);
    glLightfv(GL_LIGHT0, GL_DIFFUSE, light);
    glLightfv(GL_LIGHT0, GL_SPECULAR, light);
    glLightfv(GL_LIGHT1, GL_DIFFUSE, dim);
    glLightfv(GL_LIGHT1, GL_SPECULAR, dim);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);
    glMaterialfv(GL_FRONT, GL_SPECULAR, (float[]){0.9f, 0.9f, 0.9f, 1});
    glShadeModel(GL_PHONG_WIN);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_LIGHT1);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
}

/* Without an extension that it shows, the program has nothing to show. */
static void need(const char *extension)
{
    if (glutExtensionSupported(extension))
        return;
    fprintf(stderr, "phongblinn: this OpenGL has no %s\n", extension);
    exit(1);
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_SINGLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(720, 360);
    glutCreateWindow("phongblinn");
    need("GL_WIN_phong_shading");
    need("GL_APPLE_specular_vector");
    init();
    glutDisplayFunc(display);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
