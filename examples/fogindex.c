/*
 * fogindex: a row of columns that goes into the mist, in color index mode.
 *
 * Fog adds to a pixel's index: nothing near by, the whole fog index far away. So each thing has a ramp of
 * indexes from its own color to the color of the mist, as long as the fog index.
 *
 *   f     next equation: EXP, EXP2, LINEAR, none
 *   + -   density
 *
 * GL 1.5, 3.10 "Fog".
 */
#include <GL/glut.h>

enum { RAMP = 40, STONE = 16, ROOF = STONE + RAMP, GROUND = ROOF + RAMP, MIST = GROUND + RAMP, NONE = 3, ROWS = 9 };

static const GLenum modes[] = {GL_EXP, GL_EXP2, GL_LINEAR};
static int mode;
static float density = 0.11f;

static void set_ramp(int first, float red, float green, float blue)
{
    const float mist[3] = {0.72f, 0.76f, 0.80f}, near_by[3] = {red, green, blue};
    float cell[3];
    for (int i = 0; i < RAMP; i++) {
        const float t = (float)i / (RAMP - 1);
        for (int c = 0; c < 3; c++)
            cell[c] = (1 - t) * near_by[c] + t * mist[c];
        glutSetColor(first + i, cell[0], cell[1], cell[2]);
    }
    glutSetColor(MIST, mist[0], mist[1], mist[2]);
}

static void set_fog(void)
{
    if (mode == NONE) {
        glDisable(GL_FOG);
        return;
    }
    glEnable(GL_FOG);
    glFogi(GL_FOG_MODE, (GLint)modes[mode]);
    glFogi(GL_FOG_INDEX, RAMP - 1);
    glFogf(GL_FOG_DENSITY, density);
    glFogf(GL_FOG_START, 3);
    glFogf(GL_FOG_END, 26);
}

static void draw_column(void)
{
    glIndexi(STONE);
    glPushMatrix();
    glRotatef(-90, 1, 0, 0);
    glutSolidCone(0.32, 7, 20, 6);
    glPopMatrix();
    glIndexi(ROOF);
    glPushMatrix();
    glTranslatef(0, 2.4f, 0);
    glutSolidCube(0.75);
    glPopMatrix();
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    set_fog();
    glLoadIdentity();
    gluLookAt(0.6, 1.5, 4, -0.2, 1.1, -6, 0, 1, 0);
    glIndexi(GROUND);
    glBegin(GL_QUAD_STRIP);
    for (int z = 6; z >= -40; z -= 2) {
        glVertex3i(-30, 0, z);
        glVertex3i(30, 0, z);
    }
    glEnd();
    for (int i = 0; i < 2 * ROWS; i++) {
        glPushMatrix();
        glTranslatef(i % 2 ? 1.6f : -1.6f, 0, -3.0f * (float)(i / 2));
        draw_column();
        glPopMatrix();
    }
    glutSwapBuffers();
}

static void reshape(int w, int h)
{
    glViewport(0, 0, w, h);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(50, (double)w / h, 0.5, 60);
    glMatrixMode(GL_MODELVIEW);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 'f')
        mode = (mode + 1) % (NONE + 1);
    density += 0.01f * (float)((key == '+') - (key == '-'));
    if (density < 0)
        density = 0;
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_INDEX | GLUT_DEPTH);
    glutInitWindowSize(400, 300);
    glutCreateWindow("fogindex");
    set_ramp(STONE, 0.45f, 0.36f, 0.30f);
    set_ramp(ROOF, 0.62f, 0.22f, 0.16f);
    set_ramp(GROUND, 0.20f, 0.32f, 0.16f);
    glClearIndex(MIST);
    glEnable(GL_DEPTH_TEST);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
