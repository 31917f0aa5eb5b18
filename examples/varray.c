/*
 * varray: a landscape in three arrays.
 *
 * Positions, normals and colors lie in arrays; one call draws any number of them. There are several ways to
 * name the vertices, and all draw the same picture: indices for a whole row of triangles, runs of an array
 * made in order, single elements between glBegin and glEnd. One interleaved array can take the place of
 * three.
 *
 *   1   glDrawElements      2   glDrawRangeElements
 *   3   glArrayElement      4   glInterleavedArrays
 *   left, right   turn
 *
 * GL 1.5, 2.8 "Vertex Arrays".
 */
#include <GL/glut.h>
#include <math.h>

enum { N = 40, VERTICES = N * N, STRIP = 2 * N };

/* The layout of GL_C4F_N3F_V3F. */
static struct {
    float color[4], normal[3], position[3];
} vertices[VERTICES];
static GLushort strips[N - 1][STRIP];
static const float sea_level = -0.14f;
static char way = 'e';
static GLboolean interleaved;
static int yaw = 25; /* degrees */

/* Hills, and between them water. */
static float get_height(float x, float z)
{
    const float hills = 0.34f * sinf(2.1f * x + 0.6f) * cosf(1.7f * z) + 0.11f * sinf(5.3f * x + 2 * z);

    return fmaxf(hills - 0.08f * (x * x + z * z), sea_level);
}

static void make_vertex(int i, int j)
{
    static const float sea[3] = {0.15f, 0.35f, 0.55f}, grass[3] = {0.35f, 0.55f, 0.25f},
                       snow[3] = {0.95f, 0.95f, 0.98f};
    const float x = 3 * (float)i / (N - 1) - 1.5f, z = 3 * (float)j / (N - 1) - 1.5f, e = 0.01f;
    const float y = get_height(x, z), *color = y <= sea_level ? sea : y < 0.16f ? grass : snow;
    const float dx = (get_height(x + e, z) - y) / e, dz = (get_height(x, z + e) - y) / e;
    const float length = sqrtf(dx * dx + dz * dz + 1);

    for (int k = 0; k < 3; k++) {
        vertices[i * N + j].color[k] = color[k];
        vertices[i * N + j].normal[k] = (float[]){-dx, 1, -dz}[k] / length;
        vertices[i * N + j].position[k] = (float[]){x, y, z}[k];
    }
    vertices[i * N + j].color[3] = 1;
}

static void make_landscape(void)
{
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            make_vertex(i, j);
    for (int i = 0; i < N - 1; i++)
        for (int j = 0; j < STRIP; j++)
            strips[i][j] = (GLushort)((i + j % 2) * N + j / 2);
}

static void set_arrays(void)
{
    if (interleaved) { /* enables the three arrays too */
        glInterleavedArrays(GL_C4F_N3F_V3F, 0, vertices);
        return;
    }
    glEnableClientState(GL_COLOR_ARRAY);
    glEnableClientState(GL_NORMAL_ARRAY);
    glEnableClientState(GL_VERTEX_ARRAY);
    glColorPointer(4, GL_FLOAT, sizeof *vertices, vertices->color);
    glNormalPointer(GL_FLOAT, sizeof *vertices, vertices->normal);
    glVertexPointer(3, GL_FLOAT, sizeof *vertices, vertices->position);
}

static void draw_strip(int i)
{
    switch (way) {
    case 'e': glDrawElements(GL_TRIANGLE_STRIP, STRIP, GL_UNSIGNED_SHORT, strips[i]); break;
    case 'r': glDrawArrays(GL_LINE_STRIP, i * N, N); break;
    case 'a':
        glBegin(GL_TRIANGLE_STRIP);
        for (int j = 0; j < STRIP; j++)
            glArrayElement(strips[i][j]);
        glEnd();
        break;
    }
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glPushMatrix();
    glRotatef((float)yaw, 0, 1, 0);
    for (int i = 0; i < N - 1; i++)
        draw_strip(i);
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
    gluLookAt(0, 2.6, 4.6, 0, -0.25, 0, 0, 1, 0);
    glLightfv(GL_LIGHT0, GL_POSITION, (float[]){-2, 1.5f, 1, 0});
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 'e' || key == 'a' || key == 'r')
        way = (char)key;
    if (key == 'i')
        interleaved = !interleaved;
    set_arrays();
    glutPostRedisplay();
}

static void special(int key, int x, int y)
{
    (void)x, (void)y;
    yaw += 10 * ((key == GLUT_KEY_RIGHT) - (key == GLUT_KEY_LEFT));
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(320, 240);
    glutCreateWindow("varray");
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_COLOR_MATERIAL);
    glEnable(GL_DEPTH_TEST);
    make_landscape();
    set_arrays();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutSpecialFunc(special);
    glutMainLoop();
    return 0;
}
