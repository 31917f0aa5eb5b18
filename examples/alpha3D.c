/*
 * alpha3D: a bubble among solid things.
 *
 * The solid things are drawn first, with the depth buffer as usual. Then the transparent ones, backs before
 * fronts: tested against the depth buffer, so that a solid thing in front hides them, but not written to it,
 * so that they do not hide each other.
 *
 *   left, right   move the bubbles away and nearer
 *   m             write the depth of the bubbles too, which is wrong
 *
 * GL 1.5, 4.1.6 "Depth Buffer Test", 4.1.8 "Blending" and 4.2.2 "Fine Control of Buffer Updates"
 * (glDepthMask).
 */
#include <GL/glut.h>

static int shift; /* of the bubbles, in tenths */
static GLboolean written;

static void set_color(float red, float green, float blue, float alpha)
{
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, (float[]){red, green, blue, alpha});
}

static void draw_solids(void)
{
    set_color(0.75f, 0.55f, 0.25f, 1);
    glPushMatrix();
    glRotatef(70, 1, 0.3f, 0);
    glutSolidTorus(0.16, 1.15, 24, 64);
    glPopMatrix();
    set_color(0.70f, 0.20f, 0.18f, 1);
    glutSolidOctahedron();
}

static void draw_bubble(float x, float y, float z, double radius)
{
    glPushMatrix();
    glTranslatef(x, y, z + 0.1f * (float)shift);
    set_color(0.55f, 0.80f, 0.95f, 0.30f);
    glCullFace(GL_FRONT);
    glutSolidSphere(radius, 40, 30);
    set_color(0.55f, 0.80f, 0.95f, 0.40f);
    glCullFace(GL_BACK);
    glutSolidSphere(radius, 40, 30);
    glPopMatrix();
}

static void draw_bubbles(void)
{
    glPushAttrib(GL_ENABLE_BIT | GL_DEPTH_BUFFER_BIT | GL_LIGHTING_BIT | GL_POLYGON_BIT);
    glEnable(GL_BLEND);
    glEnable(GL_CULL_FACE);
    glDepthMask(written);
    glMaterialfv(GL_FRONT, GL_SPECULAR, (float[]){1, 1, 1, 1});
    glMaterialf(GL_FRONT, GL_SHININESS, 90);
    draw_bubble(-0.75f, 0.35f, -0.4f, 0.65);
    draw_bubble(0.45f, -0.30f, 0.7f, 0.75);
    draw_bubble(0.95f, 0.60f, 0.9f, 0.35);
    glPopAttrib();
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw_solids();
    draw_bubbles();
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(30, (double)width / height, 1, 20);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0, 0, -5.5f);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 'm')
        written = !written;
    glutPostRedisplay();
}

static void special(int key, int x, int y)
{
    (void)x, (void)y;
    shift += 2 * ((key == GLUT_KEY_RIGHT) - (key == GLUT_KEY_LEFT));
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(320, 240);
    glutCreateWindow("alpha3D");
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glLightfv(GL_LIGHT0, GL_POSITION, (float[]){-1, 1.5f, 2, 0});
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutSpecialFunc(special);
    glutMainLoop();
    return 0;
}
