/*
 * two-sided: a twisted ribbon, gold in front and blue behind.
 *
 * The ribbon turns once around itself on its way around the ring, so it shows both sides. With two-sided
 * lighting the back is lit too, with the normal reversed and with its own material. Without, the back takes
 * the front's color.
 *
 *   t        two-sided lighting on and off
 *   arrows   turn the ribbon
 *
 * GL 1.5, 2.14.1 "Lighting" (two-sided), 2.14.2 (GL_LIGHT_MODEL_TWO_SIDE) and 2.8 "Vertex Arrays"
 * (glDrawElements).
 */
#include <GL/glut.h>
#include <math.h>

enum { AROUND = 160, ACROSS = 16, ROW = ACROSS + 1 };

static float positions[(AROUND + 1) * ROW][3], normals[(AROUND + 1) * ROW][3];
static GLushort strips[AROUND][2 * ROW];
static GLboolean two_sided = GL_TRUE;
static int pitch = -50, yaw = 90; /* degrees */

/*
 * The point at angle u on the ring, v from the middle of the ribbon. With the unit vectors r (outwards), t
 * (along the ring) and z (up) it is p = r + v d, where d = cos u r + sin u z is the direction across the
 * ribbon. The normal is dp/du x dp/dv = v t - (1 + v cos u) (cos u z - sin u r), not of unit length.
 */
static void set_vertex(int index, float u, float v)
{
    const float c = cosf(u), s = sinf(u), along = 1 + v * c;

    positions[index][0] = along * c;
    positions[index][1] = along * s;
    positions[index][2] = v * s;
    normals[index][0] = along * s * c - v * s;
    normals[index][1] = along * s * s + v * c;
    normals[index][2] = -along * c;
}

static void build_ribbon(void)
{
    for (int i = 0; i <= AROUND; i++)
        for (int j = 0; j < ROW; j++)
            set_vertex(i * ROW + j, 6.2831853f * (float)i / AROUND, 0.9f * ((float)j / ACROSS - 0.5f));
    for (int i = 0; i < AROUND; i++)
        for (int j = 0; j < 2 * ROW; j++)
            strips[i][j] = (GLushort)((i + j % 2) * ROW + j / 2);
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, two_sided);
    glPushMatrix();
    glRotatef((float)pitch, 1, 0, 0);
    glRotatef((float)yaw, 0, 0, 1);
    for (int i = 0; i < AROUND; i++)
        glDrawElements(GL_TRIANGLE_STRIP, 2 * ROW, GL_UNSIGNED_SHORT, strips[i]);
    glPopMatrix();
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
    gluLookAt(0, 0, 5.6, 0, 0, 0, 0, 1, 0);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 't')
        two_sided = !two_sided;
    glutPostRedisplay();
}

static void special(int key, int x, int y)
{
    (void)x, (void)y;
    yaw += 10 * ((key == GLUT_KEY_RIGHT) - (key == GLUT_KEY_LEFT));
    pitch += 10 * ((key == GLUT_KEY_DOWN) - (key == GLUT_KEY_UP));
    glutPostRedisplay();
}

static void init(void)
{
    build_ribbon();
    glVertexPointer(3, GL_FLOAT, 0, positions);
    glNormalPointer(GL_FLOAT, 0, normals);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_NORMAL_ARRAY);
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glLightfv(GL_LIGHT0, GL_POSITION, (float[]){-1, 1.5f, 2, 0});
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (float[]){0.80f, 0.55f, 0.15f, 1});
    glMaterialfv(GL_BACK, GL_AMBIENT_AND_DIFFUSE, (float[]){0.15f, 0.40f, 0.70f, 1});
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, (float[]){0.7f, 0.7f, 0.7f, 1});
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 40);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_NORMALIZE);
    glEnable(GL_DEPTH_TEST);
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(500, 500);
    glutCreateWindow("two-sided");
    init();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutSpecialFunc(special);
    glutMainLoop();
    return 0;
}
