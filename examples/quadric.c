/*
 * quadric: spheres, cylinders, disks and parts of disks by GLU.
 *
 * A row for each way of drawing them: filled with smooth normals, filled with one normal for each facet, as
 * wires, and as silhouettes, which leave out the edges between facets that lie in one plane.
 *
 *   arrows   turn them all
 *   i        normals inward or outward
 *
 * GLU 1.3, chapter 6 "Quadrics".
 */
#include <GL/glut.h>

enum { STYLES = 4, SHAPES = 4 };

static const GLenum draw_styles[STYLES] = {GLU_FILL, GLU_FILL, GLU_LINE, GLU_SILHOUETTE};
static const GLenum normal_styles[STYLES] = {GLU_SMOOTH, GLU_FLAT, GLU_SMOOTH, GLU_NONE};
static int pitch = -60, yaw = 25; /* degrees */
static GLboolean inward;
static GLUquadric *quadric;

static void draw_shape(int shape)
{
    switch (shape) {
    case 0: gluSphere(quadric, 0.75, 16, 12); break;
    case 1:
        glTranslatef(0, 0, -0.6f);
        gluCylinder(quadric, 0.65, 0.3, 1.2, 16, 4);
        break;
    case 2: gluDisk(quadric, 0.25, 0.85, 20, 4); break;
    case 3: gluPartialDisk(quadric, 0, 0.85, 20, 4, 30, 240); break;
    }
}

static void set_style(int style)
{
    const float hue = (float)style / STYLES;

    gluQuadricDrawStyle(quadric, draw_styles[style]);
    gluQuadricNormals(quadric, normal_styles[style]);
    gluQuadricOrientation(quadric, inward ? GLU_INSIDE : GLU_OUTSIDE);
    glShadeModel(normal_styles[style] == GLU_FLAT ? GL_FLAT : GL_SMOOTH);
    if (normal_styles[style] == GLU_NONE)
        glDisable(GL_LIGHTING);
    else
        glEnable(GL_LIGHTING);
    glColor3f(0.85f - 0.5f * hue, 0.45f + 0.3f * hue, 0.35f + 0.5f * hue);
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (int style = 0; style < STYLES; style++) {
        set_style(style);
        for (int shape = 0; shape < SHAPES; shape++) {
            glPushMatrix();
            glTranslatef(2.1f * (float)shape - 3.15f, 3.15f - 2.1f * (float)style, 0);
            glRotatef((float)pitch, 1, 0, 0);
            glRotatef((float)yaw, 0, 1, 0);
            draw_shape(shape);
            glPopMatrix();
        }
    }
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(-4.3, 4.3, -4.3, 4.3, -3, 3);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 'i')
        inward = !inward;
    glutPostRedisplay();
}

static void special(int key, int x, int y)
{
    (void)x, (void)y;
    switch (key) {
    case GLUT_KEY_LEFT: yaw -= 10; break;
    case GLUT_KEY_RIGHT: yaw += 10; break;
    case GLUT_KEY_UP: pitch -= 10; break;
    case GLUT_KEY_DOWN: pitch += 10; break;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(500, 500);
    glutCreateWindow("quadric");
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    quadric = gluNewQuadric();
    glLightfv(GL_LIGHT0, GL_POSITION, (float[]){-1, 1, 2, 0});
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
    glEnable(GL_LIGHT0);
    glEnable(GL_COLOR_MATERIAL);
    glEnable(GL_DEPTH_TEST);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutSpecialFunc(special);
    glutMainLoop();
    return 0;
}
