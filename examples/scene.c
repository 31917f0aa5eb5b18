/*
 * scene: a torus, a cone and a sphere, lit four ways.
 *
 * The objects and their gray materials never change: every color in the picture comes from the lights, from
 * their ambient part, and from the ambient light of the scene, which has no source.
 *
 *   1   day: white sun, weak white ambient light
 *   2   sunset: orange sun, blue ambient light of the sky
 *   3   fog: ambient light only, the shapes go flat
 *   4   stage: a red light from the left, a blue one from the right
 *
 * GL 1.5, 2.14.1 "Lighting" and 2.14.2 (glLight, GL_LIGHT_MODEL_AMBIENT).
 */
#include <GL/glut.h>

static const struct {
    float left[4], right[4], ambient[4]; /* diffuse and specular of the two lights; ambient of the scene */
} moods[4] = {
        {{0.95f, 0.95f, 0.90f, 1}, {0, 0, 0, 1}, {0.25f, 0.25f, 0.25f, 1}},
        {{1.00f, 0.55f, 0.20f, 1}, {0, 0, 0, 1}, {0.20f, 0.28f, 0.50f, 1}},
        {{0, 0, 0, 1}, {0, 0, 0, 1}, {0.75f, 0.78f, 0.80f, 1}},
        {{0.95f, 0.20f, 0.25f, 1}, {0.20f, 0.35f, 1.00f, 1}, {0.08f, 0.08f, 0.08f, 1}},
};

static int mood = 1;

static void set_light(GLenum light, const float color[4], float x, float y, float z)
{
    glLightfv(light, GL_DIFFUSE, color);
    glLightfv(light, GL_SPECULAR, color);
    glLightfv(light, GL_POSITION, (float[]){x, y, z, 0});
    glEnable(light);
}

static void draw_objects(void)
{
    GLUquadric *quadric = gluNewQuadric();

    glPushMatrix();
    glTranslatef(-0.9f, 0.95f, 0.2f);
    glRotatef(30, 0, 1, 0);
    glRotatef(-25, 1, 0, 0);
    glutSolidTorus(0.27, 0.68, 32, 56);
    glPopMatrix();

    glPushMatrix();
    glRotatef(-90, 1, 0, 0); /* from here on z is up */
    glTranslatef(0.55f, 0.75f, 0);
    glutSolidCone(0.8, 2.1, 56, 24);
    glTranslatef(0.55f, -1.65f, 0.6f);
    glutSolidSphere(0.6, 48, 36);
    glPopMatrix();

    glPushMatrix();
    glRotatef(-90, 1, 0, 0);
    gluDisk(quadric, 0, 2.45, 72, 1);
    glPopMatrix();
    gluDeleteQuadric(quadric);
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, moods[mood].ambient);
    set_light(GL_LIGHT0, moods[mood].left, -3, 2, 2);
    set_light(GL_LIGHT1, moods[mood].right, 3, 2, 2);
    draw_objects();
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
    gluLookAt(0, 3.2, 7.4, 0, 0.65, 0, 0, 1, 0);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key >= '1' && key <= '4')
        mood = key - '1';
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(500, 500);
    glutCreateWindow("scene");
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (float[]){0.7f, 0.7f, 0.7f, 1});
    glMaterialfv(GL_FRONT, GL_SPECULAR, (float[]){0.5f, 0.5f, 0.5f, 1});
    glMaterialf(GL_FRONT, GL_SHININESS, 30);
    glEnable(GL_LIGHTING);
    glEnable(GL_DEPTH_TEST);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
