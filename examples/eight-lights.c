/*
 * eight-lights: every light that GL promises, at once.
 *
 * Two faint directional lights, three bulbs that fade with distance, and three spots that look down on the
 * stage. Bulbs and spots are drawn where they are. Each light adds its own term to the sum; switch some off
 * to see theirs.
 *
 *   1 to 8        a light on and off (1, 2 directional, 3 to 5 bulbs, 6 to 8 spots)
 *   left, right   the lights go around the stage
 *
 * GL 1.5, 2.14.1 "Lighting" (the sum over lights, attenuation, spots) and 2.14.2 (glLight).
 */
#include <GL/glut.h>

static const struct light {
    float color[4], position[4]; /* w = 0: the direction it comes from */
    float spot_cutoff;           /* degrees; 180: no spot */
    float quadratic_attenuation;
} lights[8] = {
        {{0.14f, 0.14f, 0.22f, 1}, {-1, 1.4f, 1, 0}, 180, 0},
        {{0.22f, 0.17f, 0.12f, 1}, {1, 1.4f, 1, 0}, 180, 0},
        {{1.00f, 0.25f, 0.20f, 1}, {1.6f, 0.35f, -0.3f, 1}, 180, 1.2f},
        {{0.25f, 0.90f, 0.30f, 1}, {-1, 0.35f, -1.2f, 1}, 180, 1.2f},
        {{0.25f, 0.40f, 1.00f, 1}, {-0.55f, 0.35f, 1.5f, 1}, 180, 1.2f},
        {{0.90f, 0.85f, 0.30f, 1}, {0.5f, 2.1f, -1.4f, 1}, 28, 0.04f},
        {{0.85f, 0.35f, 0.85f, 1}, {-1.5f, 2.1f, 0.25f, 1}, 28, 0.04f},
        {{0.30f, 0.85f, 0.85f, 1}, {0.95f, 2.1f, 1.15f, 1}, 28, 0.04f},
};

static float turn; /* of the lights around the stage, degrees */

/* A ball for a bulb, a cone for a spot. */
static void draw_lamp(const struct light *light)
{
    glDisable(GL_LIGHTING);
    glColor3fv(light->color);
    glTranslatef(light->position[0], light->position[1], light->position[2]);
    glRotatef(-90, 1, 0, 0);
    if (light->spot_cutoff == 180)
        glutSolidSphere(0.06, 16, 12);
    else
        glutSolidCone(0.09, 0.22, 20, 1);
    glEnable(GL_LIGHTING);
}

static void place_light(GLenum name, const struct light *light)
{
    glPushMatrix();
    glRotatef(turn, 0, 1, 0);
    glLightfv(name, GL_POSITION, light->position);
    glLightfv(name, GL_SPOT_DIRECTION, (float[]){0, -1, 0});
    if (light->position[3] != 0 && glIsEnabled(name))
        draw_lamp(light);
    glPopMatrix();
}

static void display(void)
{
    GLUquadric *quadric = gluNewQuadric();

    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (unsigned i = 0; i < 8; i++)
        place_light(GL_LIGHT0 + i, &lights[i]);
    glPushMatrix();
    glRotatef(-90, 1, 0, 0);
    gluDisk(quadric, 0, 2.35, 120, 70);
    glTranslatef(0, 0, 0.75f);
    gluSphere(quadric, 0.75, 72, 54);
    glPopMatrix();
    gluDeleteQuadric(quadric);
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
    gluLookAt(0, 4.2, 7, 0, 0.55, 0, 0, 1, 0);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    const GLenum name = GL_LIGHT0 + key - '1';
    if (key >= '1' && key <= '8')
        (glIsEnabled(name) ? glDisable : glEnable)(name);
    glutPostRedisplay();
}

static void special(int key, int x, int y)
{
    (void)x, (void)y;
    if (key == GLUT_KEY_LEFT || key == GLUT_KEY_RIGHT)
        turn += key == GLUT_KEY_LEFT ? -15 : 15;
    glutPostRedisplay();
}

static void init_light(GLenum name, const struct light *light)
{
    glLightfv(name, GL_DIFFUSE, light->color);
    glLightfv(name, GL_SPECULAR, light->color);
    glLightf(name, GL_SPOT_CUTOFF, light->spot_cutoff);
    glLightf(name, GL_SPOT_EXPONENT, 30);
    glLightf(name, GL_QUADRATIC_ATTENUATION, light->quadratic_attenuation);
    glEnable(name);
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(500, 500);
    glutCreateWindow("eight-lights");
    glClearColor(0.04f, 0.04f, 0.06f, 1);
    for (unsigned i = 0; i < 8; i++)
        init_light(GL_LIGHT0 + i, &lights[i]);
    glMaterialfv(GL_FRONT, GL_SPECULAR, (float[]){0.5f, 0.5f, 0.5f, 1});
    glMaterialf(GL_FRONT, GL_SHININESS, 40);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);
    glEnable(GL_LIGHTING);
    glEnable(GL_DEPTH_TEST);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutSpecialFunc(special);
    glutMainLoop();
    return 0;
}
