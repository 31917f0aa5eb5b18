/*
 * polyoff: a solid and its own wires, without the stitching.
 *
 * The same solid is drawn twice: filled and lit, then as lines in one color. Both have the same depth, so the
 * lines would be torn. Polygon offset pushes the filled polygons back by factor times their slope plus some
 * units.
 *
 *   o      offset on and off
 *   f, F   factor 0.5 more, less
 *   u, U   one unit more, less
 *
 * GL 1.5, 3.5.4 "Options Controlling Polygon Rasterization" (glPolygonMode) and 3.5.5 "Depth Offset".
 */
#include <GL/glut.h>

static GLboolean offset = GL_TRUE;
static float factor = 1, units = 1;

static void draw_solid(void)
{
    glPushMatrix();
    glRotatef(-60, 1, 0, 0);
    glRotatef(20, 0, 1, 0);
    glutSolidSphere(0.85, 24, 16);
    glutSolidTorus(0.16, 1.35, 12, 36);
    glPopMatrix();
}

static void draw_filled(void)
{
    glPushAttrib(GL_ENABLE_BIT | GL_POLYGON_BIT);
    glEnable(GL_LIGHTING);
    if (offset)
        glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(factor, units);
    draw_solid();
    glPopAttrib();
}

static void draw_wires(void)
{
    glPushAttrib(GL_POLYGON_BIT | GL_CURRENT_BIT);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glColor3f(1, 0.85f, 0.45f);
    draw_solid();
    glPopAttrib();
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw_filled();
    draw_wires();
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
    gluLookAt(0, 0, 6.5, 0, 0, 0, 0, 1, 0);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    switch (key) {
    case 'o': offset = !offset; break;
    case 'f': factor += 0.5f; break;
    case 'F': factor -= 0.5f; break;
    case 'u': units += 1; break;
    case 'U': units -= 1; break;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(500, 500);
    glutCreateWindow("polyoff");
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glLightfv(GL_LIGHT0, GL_POSITION, (float[]){-1, 1.5f, 2, 0});
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (float[]){0.25f, 0.40f, 0.60f, 1});
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
