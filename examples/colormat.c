/*
 * colormat: glColor as a material, in four ways.
 *
 * Four spheres of gray are drawn with the same current color. GL_COLOR_MATERIAL lets another property of the
 * material follow it for each: ambient and diffuse (upper left), ambient (upper right), specular (lower left)
 * and emission.
 *
 *   left, middle, right button   more red, green, blue in the current color, back to 0 after 1
 *   m                            color material on and off
 *
 * GL 1.5, 2.14.3 "ColorMaterial".
 */
#include <GL/glut.h>

static const GLenum followers[4] = {GL_AMBIENT_AND_DIFFUSE, GL_AMBIENT, GL_SPECULAR, GL_EMISSION};

static float color[3] = {1, 0.4f, 0};
static GLboolean color_material = GL_TRUE;

/* Color material writes the property it follows; push and pop give each sphere the same gray to start from.
 */
static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (int i = 0; i < 4; i++) {
        glPushAttrib(GL_LIGHTING_BIT);
        glColorMaterial(GL_FRONT, followers[i]);
        if (color_material)
            glEnable(GL_COLOR_MATERIAL);
        glColor3fv(color);
        glPushMatrix();
        glTranslatef(i % 2 ? 1 : -1, i / 2 ? -1 : 1, 0);
        glutSolidSphere(0.85, 56, 40);
        glPopMatrix();
        glPopAttrib();
    }
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    const double fit = 2.05 / (width < height ? width : height); /* units per half pixel */

    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(-fit * width, fit * width, -fit * height, fit * height, -2, 2);
    glMatrixMode(GL_MODELVIEW);
}

static void mouse(int button, int state, int x, int y)
{
    (void)x, (void)y;
    if (state != GLUT_DOWN || button < GLUT_LEFT_BUTTON || button > GLUT_RIGHT_BUTTON)
        return;
    color[button] += 0.2f; /* the three buttons are numbered 0, 1, 2 */
    if (color[button] > 1.01f)
        color[button] = 0;
    glutPostRedisplay();
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 'm')
        color_material = !color_material;
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(500, 500);
    glutCreateWindow("colormat");
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glLightfv(GL_LIGHT0, GL_POSITION, (float[]){1, 1, 1, 0});
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, (float[]){0.4f, 0.4f, 0.4f, 1});
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (float[]){0.35f, 0.36f, 0.38f, 1});
    glMaterialfv(GL_FRONT, GL_SPECULAR, (float[]){0.3f, 0.3f, 0.3f, 1});
    glMaterialf(GL_FRONT, GL_SHININESS, 16);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutMouseFunc(mouse);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
