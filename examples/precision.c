/*
 * precision: the same scene from coordinates that leave fewer and fewer digits for it.
 *
 * Above, the scene stands farther and farther from the origin of the world, and the camera with it: eye
 * coordinates are small differences of large numbers. Below, two axes of object space are more and more
 * nearly parallel: the modelview matrix is nearly singular, and its inverse, which turns the normals, hardly
 * known. What vertices lose when they are rounded to floats, no renderer can mend. What is lost after that,
 * in products of matrices, in eye coordinates, in lighting, is the renderer's: draw it with
 * FIXEDGL_ACCURACY=exact too.
 *
 *   + and -   ten times as far and as nearly parallel, or as little
 *
 * GL 1.5, 2.11.2 "Matrices", 2.11.3 "Normal Transformation".
 */
#include <GL/glut.h>
#include <math.h>

enum { COLUMNS = 3, TILES = 24, SLICES = 40, STACKS = 24 };

static const double pi = 3.14159265358979324;

static double factor = 1; /* by the keys */

/* Where a point of the scene is in object coordinates, and its normal: moved, then sheared. */
static struct {
    double offset[3];
    double angle; /* between the axes x and y of object space; 0: they are at right angles */
} space;

static void put_vertex(const double n[3], double x, double y, double z)
{
    if (space.angle == 0) {
        glNormal3d(n[0], n[1], n[2]);
        glVertex3d(x + space.offset[0], y + space.offset[1], z + space.offset[2]);
    } else {
        /* x' + y' = x, angle y' = y; normals by the transpose of the matrix that solves it */
        glNormal3d(n[0], n[0] + space.angle * n[1], n[2]);
        glVertex3d(x - y / space.angle, y / space.angle, z);
    }
}

static void draw_floor(void)
{
    static const double up[3] = {0, 1, 0};
    const double step = 3.6 / TILES;
    for (int i = 0; i < TILES; i++) {
        glBegin(GL_QUAD_STRIP);
        for (int j = 0; j <= TILES; j++) {
            put_vertex(up, i * step - 1.8, -0.8, j * step - 1.8);
            put_vertex(up, (i + 1) * step - 1.8, -0.8, j * step - 1.8);
        }
        glEnd();
    }
}

static void draw_sphere(void)
{
    for (int i = 0; i < STACKS; i++) {
        glBegin(GL_TRIANGLE_STRIP);
        for (int j = 0; j <= SLICES; j++)
            for (int k = 0; k < 2; k++) {
                const double a = pi * (i + k) / STACKS, b = 2 * pi * j / SLICES;
                const double n[3] = {sin(a) * cos(b), -cos(a), sin(a) * sin(b)};
                put_vertex(n, 0.8 * n[0], 0.8 * n[1], 0.8 * n[2]);
            }
        glEnd();
    }
}

/* The camera, then the scene's own space. The light stands in that space too, close to the floor. */
static void draw_scene(void)
{
    const double *to = space.offset;
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    if (space.angle == 0) {
        gluLookAt(2.2 + to[0], 1.8 + to[1], 4 + to[2], to[0], to[1] - 0.2, to[2], 0, 1, 0);
        glLightfv(GL_LIGHT0, GL_POSITION,
                  (float[]){(float)(-0.2 + to[0]), (float)(0.6 + to[1]), (float)(1.7 + to[2]), 1});
    } else {
        gluLookAt(2.2, 1.8, 4, 0, -0.2, 0, 0, 1, 0);
        glLightfv(GL_LIGHT0, GL_POSITION, (float[]){-0.2f, 0.6f, 1.7f, 1});
        glMultMatrixd((double[]){1, 0, 0, 0, 1, space.angle, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    }
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (float[]){0.55f, 0.55f, 0.50f, 1});
    draw_floor();
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (float[]){0.80f, 0.45f, 0.15f, 1});
    draw_sphere();
}

static void display(void)
{
    static const double far_away[COLUMNS] = {0, 2e4, 5e5}, angles[COLUMNS] = {1e-2, 1e-4, 1e-6};
    const int width = glutGet(GLUT_WINDOW_WIDTH) / COLUMNS, height = glutGet(GLUT_WINDOW_HEIGHT) / 2;
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(45, (double)width / height, 1, 20);
    for (int i = 0; i < COLUMNS; i++) {
        glViewport(i * width, height, width, height);
        space.angle = 0;
        space.offset[0] = far_away[i] * factor;
        space.offset[1] = -0.7 * far_away[i] * factor;
        space.offset[2] = 0.4 * far_away[i] * factor;
        draw_scene();
        glViewport(i * width, 0, width, height);
        space.angle = angles[i] / factor;
        draw_scene();
    }
    glFlush();
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == '+' && factor < 1e3)
        factor *= 10;
    else if (key == '-' && factor > 1e-3)
        factor /= 10;
    glutPostRedisplay();
}

static void init(void)
{
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glMaterialfv(GL_FRONT, GL_SPECULAR, (float[]){0.6f, 0.6f, 0.6f, 1});
    glMaterialf(GL_FRONT, GL_SHININESS, 30);
    glLightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 0.15f);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);
    glEnable(GL_NORMALIZE);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_SINGLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(600, 400);
    glutCreateWindow("precision");
    init();
    glutDisplayFunc(display);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
