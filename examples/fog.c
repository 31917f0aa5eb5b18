/*
 * fog: an avenue of trees that goes into the mist.
 *
 * Fog mixes each fragment with the fog color by its distance: all of it at the far end, or thicker and
 * thicker with the exponential of the distance or of its square. The background has the fog's color.
 *
 *   f     next equation: EXP, EXP2, LINEAR, none
 *   + -   density
 *
 * GL 1.5, 3.10 "Fog".
 */
#include <GL/glut.h>

enum { NONE = 3 };

static const GLenum modes[] = {GL_EXP, GL_EXP2, GL_LINEAR};
static int mode;
static float density = 0.10f;

static void set_fog(void)
{
    if (mode == NONE) {
        glDisable(GL_FOG);
        return;
    }
    glEnable(GL_FOG);
    glFogi(GL_FOG_MODE, (int)modes[mode]);
    glFogf(GL_FOG_DENSITY, density);
    glFogf(GL_FOG_START, 4);
    glFogf(GL_FOG_END, 24);
}

static void set_color(float red, float green, float blue)
{
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (float[]){red, green, blue, 1});
}

static void draw_ground(void)
{
    glNormal3f(0, 1, 0);
    set_color(0.30f, 0.42f, 0.22f);
    glBegin(GL_QUADS);
    glVertex3f(-20, 0, 6);
    glVertex3f(20, 0, 6);
    glVertex3f(20, 0, -40);
    glVertex3f(-20, 0, -40);
    set_color(0.62f, 0.52f, 0.38f);
    glVertex3f(-0.8f, 0.01f, 6);
    glVertex3f(0.8f, 0.01f, 6);
    glVertex3f(0.8f, 0.01f, -40);
    glVertex3f(-0.8f, 0.01f, -40);
    glEnd();
}

static void draw_tree(float x, float z)
{
    glPushMatrix();
    glTranslatef(x, 0, z);
    glRotatef(-90, 1, 0, 0);
    set_color(0.35f, 0.22f, 0.14f);
    glutSolidCone(0.16, 1.6, 12, 2);
    for (int i = 0; i < 3; i++) {
        glTranslatef(0, 0, 0.5f);
        set_color(0.10f + 0.05f * (float)i, 0.34f + 0.05f * (float)i, 0.16f);
        glutSolidCone(0.75 - 0.15 * i, 0.9, 20, 2);
    }
    glPopMatrix();
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    set_fog();
    draw_ground();
    for (int i = 0; i < 14; i++) {
        draw_tree(-1.7f, 3.2f - 2.4f * (float)i);
        draw_tree(1.7f, 3.2f - 2.4f * (float)i);
    }
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(35, (double)width / height, 0.5, 60);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(0.4, 1.7, 7.5, 0, 1.1, 0, 0, 1, 0);
    glLightfv(GL_LIGHT0, GL_POSITION, (float[]){-2, 3, 2, 0});
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 'f')
        mode = (mode + 1) % (NONE + 1);
    density *= key == '+' ? 1.25f : key == '-' ? 0.8f : 1;
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(320, 240);
    glutCreateWindow("fog");
    glClearColor(0.78f, 0.80f, 0.82f, 1);
    glFogfv(GL_FOG_COLOR, (float[]){0.78f, 0.80f, 0.82f, 1});
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
