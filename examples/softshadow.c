/*
 * softshadow: a lamp that is a square and not a point. The scene is drawn once for each of a few points on the lamp, with
 * a sharp shadow, and the mean of the pictures is taken in the accumulation buffer: where some of the lamp is seen, the
 * shadow is soft, the more so the farther what casts it is from the floor.
 *
 * The shadow on the floor is that of the objects, flattened onto it away from the light by a matrix, and drawn to the
 * stencil buffer alone. Then the floor is drawn twice: lit where no shadow is marked, with the scene's ambient light
 * where one is.
 *
 *   + and -     more or fewer points, from 1 x 1 to 8 x 8
 *   l and L     a smaller or larger lamp
 *
 * GL 1.5, 4.1.4 "Stencil Test", 4.2.4 "The Accumulation Buffer", 2.14.1 "Lighting".
 */
#include <GL/glut.h>

static int points = 5, lamp_size = 5;

static void material(float r, float g, float b)
{
    const float color[4] = {r, g, b, 1};
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, color);
}

static void objects(void)
{
    glPushMatrix();
    glTranslatef(-0.9f, 1.1f, 0.2f);
    glRotatef(70, 1, 0.2f, 0);
    material(0.75f, 0.25f, 0.15f);
    glutSolidTorus(0.2, 0.6, 20, 36);
    glPopMatrix();

    glPushMatrix();
    glTranslatef(0.9f, 0.45f, 0.5f);
    material(0.20f, 0.40f, 0.70f);
    glutSolidSphere(0.45, 32, 24);
    glPopMatrix();

    glPushMatrix();
    glTranslatef(0.7f, 1, -1.4f);
    glScalef(0.25f, 2, 0.25f);
    material(0.35f, 0.60f, 0.30f);
    glutSolidCube(1);
    glPopMatrix();
}

static void floor_tiles(void)
{
    material(0.62f, 0.60f, 0.55f);
    glNormal3f(0, 1, 0);
    for (int i = -8; i < 8; i++) {
        glBegin(GL_QUAD_STRIP);
        for (int k = -8; k <= 8; k++) {
            glVertex3f(0.5f * (float)i, 0, 0.5f * (float)k);
            glVertex3f(0.5f * (float)i + 0.5f, 0, 0.5f * (float)k);
        }
        glEnd();
    }
}

/* Everything onto the plane y = 0, along the rays from the light. */
static void flatten(const float light[4])
{
    float m[16] = {0};

    for (int i = 0; i < 4; i++) {
        m[5 * i] = light[1];
        m[4 + i] -= light[i];
    }
    glMultMatrixf(m);
}

/* Marks the floor's shadow in the stencil buffer, which was cleared. */
static void mark_shadow(const float light[4])
{
    glDisable(GL_LIGHTING);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_STENCIL_TEST);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glStencilFunc(GL_ALWAYS, 1, 1);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    glPushMatrix();
    flatten(light);
    objects();
    glPopMatrix();
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
}

static void draw_floor(void)
{
    glStencilFunc(GL_EQUAL, 0, 1);
    floor_tiles();
    glStencilFunc(GL_EQUAL, 1, 1);
    glDisable(GL_LIGHT0);
    floor_tiles();
    glEnable(GL_LIGHT0);
    glDisable(GL_STENCIL_TEST);
}

static void draw_lit_by(const float light[4])
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glLightfv(GL_LIGHT0, GL_POSITION, light);
    mark_shadow(light);
    draw_floor();
    objects();
}

static void display(void)
{
    glClear(GL_ACCUM_BUFFER_BIT);
    for (int i = 0; i < points; i++)
        for (int k = 0; k < points; k++) {
            const float size = 0.2f * (float)lamp_size, step = size / (float)points;
            const float light[4] = {-1.2f - size / 2 + step * ((float)i + 0.5f), 4.5f,
                                    1.5f - size / 2 + step * ((float)k + 0.5f), 1};
            draw_lit_by(light);
            glAccum(GL_ACCUM, 1.0f / (float)(points * points));
        }
    glAccum(GL_RETURN, 1);
    glFlush();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(35, (double)width / height, 1, 20);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(0.5, 3.6, 6, 0, 0.5, 0, 0, 1, 0);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == '+' && points < 8)
        points++;
    else if (key == '-' && points > 1)
        points--;
    else if (key == 'L' && lamp_size < 12)
        lamp_size++;
    else if (key == 'l' && lamp_size > 0)
        lamp_size--;
    glutPostRedisplay();
}

static void init(void)
{
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, (float[]){0.25f, 0.25f, 0.28f, 1});
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);
    glMaterialfv(GL_FRONT, GL_SPECULAR, (float[]){0.2f, 0.2f, 0.2f, 1});
    glMaterialf(GL_FRONT, GL_SHININESS, 30);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_NORMALIZE);
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_SINGLE | GLUT_RGB | GLUT_DEPTH | GLUT_STENCIL | GLUT_ACCUM);
    glutInitWindowSize(600, 450);
    glutCreateWindow("softshadow");
    init();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
