/*
 * robot: an arm of boxes, each moving with the one before it.
 *
 * Every joint is a rotation about the end of the last part. The scaling that makes a box of a cube is inside
 * a push and pop, so it does not reach the parts that follow; it also stretches the normals, which
 * GL_NORMALIZE repairs.
 *
 *   b, B   turn the base          s, S   bend the shoulder
 *   e, E   bend the elbow         f, F   open and close the fingers
 *
 * GL 1.5, 2.11.2 "Matrices" and 2.11.3 "Normal Transformation".
 */
#include <GL/glut.h>

static int base = -25, shoulder = 55, elbow = -70, fingers = 25; /* degrees */

/* A box from the origin along x, and the joint that it hangs on; leaves the origin at the box's far end. */
static void draw_part(float length, float thickness)
{
    glColor3f(0.30f, 0.32f, 0.36f);
    glutSolidSphere(0.72 * (double)thickness, 32, 24);
    glColor3f(0.90f, 0.60f, 0.15f);
    glPushMatrix();
    glTranslatef(length / 2, 0, 0);
    glScalef(length, thickness, thickness);
    glutSolidCube(1);
    glPopMatrix();
    glTranslatef(length, 0, 0);
}

static void draw_fingers(void)
{
    for (int side = -1; side <= 1; side += 2) {
        glPushMatrix();
        glRotatef((float)(side * fingers), 0, 0, 1);
        draw_part(0.4f, 0.12f);
        glRotatef((float)(-side * (fingers + 10)), 0, 0, 1);
        draw_part(0.3f, 0.1f);
        glPopMatrix();
    }
}

static void draw_robot(void)
{
    glPushMatrix();
    glRotatef((float)base, 0, 1, 0);
    glColor3f(0.30f, 0.32f, 0.36f);
    glPushMatrix();
    glScalef(1, 0.3f, 1);
    glutSolidCube(1.2);
    glPopMatrix();
    glTranslatef(0, 0.35f, 0);
    glRotatef((float)shoulder, 0, 0, 1);
    draw_part(1.6f, 0.4f);
    glRotatef((float)elbow, 0, 0, 1);
    draw_part(1.3f, 0.3f);
    draw_fingers();
    glPopMatrix();
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw_robot();
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(36, (double)width / height, 1, 20);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(0, 2, 7, 0.95, 0.75, 0, 0, 1, 0);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    switch (key) {
    case 'b': base += 10; break;
    case 'B': base -= 10; break;
    case 's': shoulder += 5; break;
    case 'S': shoulder -= 5; break;
    case 'e': elbow += 5; break;
    case 'E': elbow -= 5; break;
    case 'f': fingers += fingers < 60 ? 5 : 0; break;
    case 'F': fingers -= fingers > 0 ? 5 : 0; break;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(500, 500);
    glutCreateWindow("robot");
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glLightfv(GL_LIGHT0, GL_POSITION, (float[]){-1, 2, 2, 0});
    glMaterialfv(GL_FRONT, GL_SPECULAR, (float[]){0.4f, 0.4f, 0.4f, 1});
    glMaterialf(GL_FRONT, GL_SHININESS, 20);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_COLOR_MATERIAL);
    glEnable(GL_NORMALIZE);
    glEnable(GL_DEPTH_TEST);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
