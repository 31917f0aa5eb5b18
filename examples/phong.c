/*
 * phong: the same coarse ball three times, with its color decided once for each polygon, vertex and pixel.
 *
 * Left GL_FLAT: each polygon has the color of one vertex. Middle GL_SMOOTH, after Gouraud: the lighting equation
 * at the vertices, colors interpolated between them; a highlight between vertices is lost and the mesh shows.
 * Right GL_PHONG_WIN, after Phong: the normals are interpolated, and the equation is evaluated at each pixel. The
 * outline stays coarse: shading moves no vertex.
 *
 *   + and -        more or fewer polygons
 *   left, right    turn the balls
 *   s              make the light a spot, whose edge needs the pixels more than any highlight
 *
 * GL 1.5, 2.14.7 "Flatshading"; extension GL_WIN_phong_shading.
 */
#include <GL/glut.h>

#include <stdio.h>
#include <stdlib.h>

#ifndef GL_PHONG_WIN
#define GL_PHONG_WIN 0x80EA
#endif

static int slices = 10, turned, spot;

static void ball(GLenum shade_model, float x)
{
    glShadeModel(shade_model);
    glPushMatrix();
    glTranslatef(x, 0, 0);
    glLightfv(GL_LIGHT0, GL_POSITION, (float[]){-2, 3, 8, 1}); /* the same place for each ball */
    glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, (float[]){2, -3, -8});
    glRotatef(20, 1, 0, 0);
    glRotatef(5 * (float)turned, 0, 1, 0);
    glRotatef(-90, 1, 0, 0);
    glutSolidSphere(1, slices, slices / 2 + 1);
    glPopMatrix();
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, spot ? 4 : 180);
    ball(GL_FLAT, -2.2f);
    ball(GL_SMOOTH, 0);
    ball(GL_PHONG_WIN, 2.2f);
    glFlush();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(22, (double)width / height, 1, 20);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0, 0, -7);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == '+' && slices < 60)
        slices += 2;
    else if (key == '-' && slices > 4)
        slices -= 2;
    else if (key == 's')
        spot = !spot;
    glutPostRedisplay();
}

static void special(int key, int x, int y)
{
    (void)x, (void)y;
    turned += key == GLUT_KEY_RIGHT ? 1 : key == GLUT_KEY_LEFT ? -1 : 0;
    glutPostRedisplay();
}

static void init(void)
{
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glLightfv(GL_LIGHT0, GL_AMBIENT, (float[]){0.1f, 0.1f, 0.1f, 1});
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (float[]){0.15f, 0.45f, 0.50f, 1});
    glMaterialfv(GL_FRONT, GL_SPECULAR, (float[]){0.9f, 0.9f, 0.8f, 1});
    glMaterialf(GL_FRONT, GL_SHININESS, 40);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
}

/* Without an extension that it shows, the program has nothing to show. */
static void need(const char *extension)
{
    if (glutExtensionSupported(extension))
        return;
    fprintf(stderr, "phong: this OpenGL has no %s\n", extension);
    exit(1);
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_SINGLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(720, 260);
    glutCreateWindow("phong");
    need("GL_WIN_phong_shading");
    init();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutSpecialFunc(special);
    glutMainLoop();
    return 0;
}
