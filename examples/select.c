/*
 * select: who is inside the box?
 *
 * A view volume need not be that of a picture. The window shows five named shapes and a wire box; selection
 * mode, with the box as the view volume, says which shapes reach into it. They light up, and their hit
 * records are printed.
 *
 *   arrows         move the box left, right, away and near
 *   + and -        grow and shrink it
 *
 * GL 1.5, 5.2 "Selection"; 2.12 "Clipping".
 */
#include <GL/glut.h>
#include <stdio.h>

enum { SHAPES = 5 };

static const float places[SHAPES][3] = {{-2.2f, 0, 0.5f},
                                        {-0.9f, 0.3f, -1.2f},
                                        {0.2f, -0.2f, 0.9f},
                                        {1.3f, 0.2f, -0.6f},
                                        {2.3f, -0.1f, 0.8f}};
static GLboolean inside[SHAPES];
static float box[3] = {0.2f, 0, 0}, half = 0.8f; /* center, half the side */

static void draw_shape(int i)
{
    glPushMatrix();
    glTranslatef(places[i][0], places[i][1], places[i][2]);
    switch (i) {
    case 0: glutSolidCube(0.8); break;
    case 1: glutSolidSphere(0.5, 24, 16); break;
    case 2: glutSolidCone(0.45, 0.9, 24, 8); break;
    case 3: glutSolidTorus(0.16, 0.4, 12, 24); break;
    case 4:
        glScalef(0.45f, 0.45f, 0.45f);
        glutSolidOctahedron();
        break;
    }
    glPopMatrix();
}

static void print_hits(const GLuint *hits, int n)
{
    printf("%d in the box:", n);
    for (int i = 0; i < n; i++, hits += 4) {
        inside[hits[3]] = GL_TRUE;
        printf(" %u (%.3f to %.3f)", hits[3], hits[1] / 4294967295.0, hits[2] / 4294967295.0);
    }
    printf("\n");
}

static void look_into_box(void)
{
    GLuint hits[4 * SHAPES];

    for (int i = 0; i < SHAPES; i++)
        inside[i] = GL_FALSE;
    glSelectBuffer(4 * SHAPES, hits);
    glRenderMode(GL_SELECT);
    glInitNames();
    glPushName(0);
    glMatrixMode(GL_PROJECTION);
    glPushMatrix();
    glLoadIdentity();
    glOrtho((double)(box[0] - half), (double)(box[0] + half), (double)(box[1] - half),
            (double)(box[1] + half), (double)(-box[2] - half), (double)(-box[2] + half));
    glMatrixMode(GL_MODELVIEW);
    glPushMatrix();
    glLoadIdentity();
    for (int i = 0; i < SHAPES; i++) {
        glLoadName((GLuint)i);
        draw_shape(i);
    }
    glPopMatrix();
    glMatrixMode(GL_PROJECTION);
    glPopMatrix();
    glMatrixMode(GL_MODELVIEW);
    print_hits(hits, glRenderMode(GL_RENDER));
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    look_into_box();
    for (int i = 0; i < SHAPES; i++) {
        glMaterialfv(GL_FRONT, GL_EMISSION, inside[i] ? (float[]){0.45f, 0.3f, 0, 1} : (float[]){0, 0, 0, 1});
        draw_shape(i);
    }
    glDisable(GL_LIGHTING);
    glColor3f(0.6f, 0.85f, 0.95f);
    glPushMatrix();
    glTranslatef(box[0], box[1], box[2]);
    glutWireCube(2 * (double)half);
    glPopMatrix();
    glEnable(GL_LIGHTING);
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(40, (double)width / height, 1, 20);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(1, 3.5, 7.5, 0, 0, 0, 0, 1, 0);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == '+' && half < 2)
        half += 0.2f;
    if (key == '-' && half > 0.3f)
        half -= 0.2f;
    glutPostRedisplay();
}

static void special(int key, int x, int y)
{
    (void)x, (void)y;
    switch (key) {
    case GLUT_KEY_LEFT: box[0] -= 0.3f; break;
    case GLUT_KEY_RIGHT: box[0] += 0.3f; break;
    case GLUT_KEY_UP: box[2] -= 0.3f; break;
    case GLUT_KEY_DOWN: box[2] += 0.3f; break;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(500, 400);
    glutCreateWindow("select");
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glLightfv(GL_LIGHT0, GL_POSITION, (float[]){-1, 2, 2, 0});
    glMaterialfv(GL_FRONT, GL_DIFFUSE, (float[]){0.5f, 0.55f, 0.65f, 1});
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_NORMALIZE);
    glEnable(GL_DEPTH_TEST);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutSpecialFunc(special);
    glutMainLoop();
    return 0;
}
