/*
 * surface: a NURBS surface, drawn by GLU through evaluators.
 *
 * A ring mountain: six by six control points, cubic in both directions. GLU cuts the surface into Bezier
 * patches, hands them to glMap2f and draws them with glEvalMesh2, fine enough for the picture's size.
 *
 *   c        control points on and off
 *   o        filled or outlined polygons
 *   + and -  raise and lower the mountain
 *
 * GL 1.5, 5.1 "Evaluators"; GLU 1.3, chapter 7.
 */
#include <GL/glut.h>

enum { SIZE = 6, ORDER = 4 };

static GLfloat points[SIZE][SIZE][3];
static GLfloat knots[SIZE + ORDER] = {0, 0, 0, 0, 1, 2, 3, 3, 3, 3};
static GLUnurbsObj *nurbs;
static GLboolean show_points, outlined;
static float height = 2.5f;

static void place_points(void)
{
    for (int i = 0; i < SIZE; i++) {
        for (int j = 0; j < SIZE; j++) {
            const int ring = (i == 0 || i == SIZE - 1 || j == 0 || j == SIZE - 1)   ? 0
                             : (i == 1 || i == SIZE - 2 || j == 1 || j == SIZE - 2) ? 1
                                                                                    : 2;
            points[i][j][0] = 1.2f * (float)i - 3;
            points[i][j][1] = 1.2f * (float)j - 3;
            points[i][j][2] = ring == 1 ? height : ring == 2 ? -height : -0.5f;
        }
    }
}

static void draw_points(void)
{
    glPushAttrib(GL_ENABLE_BIT);
    glDisable(GL_LIGHTING);
    glPointSize(5);
    glColor3f(0.95f, 0.85f, 0.3f);
    glBegin(GL_POINTS);
    for (int i = 0; i < SIZE * SIZE; i++)
        glVertex3fv(points[i / SIZE][i % SIZE]);
    glEnd();
    glPopAttrib();
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glPushMatrix();
    glRotatef(-50, 1, 0, 0);
    glRotatef(30, 0, 0, 1);
    gluNurbsProperty(nurbs, GLU_DISPLAY_MODE, outlined ? (float)GLU_OUTLINE_POLYGON : (float)GLU_FILL);
    gluBeginSurface(nurbs);
    gluNurbsSurface(nurbs, SIZE + ORDER, knots, SIZE + ORDER, knots, SIZE * 3, 3, points[0][0], ORDER, ORDER,
                    GL_MAP2_VERTEX_3);
    gluEndSurface(nurbs);
    if (show_points)
        draw_points();
    glPopMatrix();
    glutSwapBuffers();
}

static void reshape(int width, int window_height)
{
    glViewport(0, 0, width, window_height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(42, (double)width / window_height, 1, 30);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0, 0, -10);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    switch (key) {
    case 'c': show_points = !show_points; break;
    case 'o': outlined = !outlined; break;
    case '+': height += 0.5f; break;
    case '-': height -= 0.5f; break;
    }
    place_points();
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(500, 500);
    glutCreateWindow("surface");
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    nurbs = gluNewNurbsRenderer();
    gluNurbsProperty(nurbs, GLU_SAMPLING_TOLERANCE, 25);
    place_points();
    glLightfv(GL_LIGHT0, GL_POSITION, (float[]){-3, 3, 5, 0});
    glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, (float[]){0.7f, 0.45f, 0.6f, 1});
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, (float[]){0.8f, 0.8f, 0.8f, 1});
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 60);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_AUTO_NORMAL);
    glEnable(GL_NORMALIZE);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
