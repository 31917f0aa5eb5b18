/*
 * mvarray: a flag of ribbons, many strips in one call, from buffer objects.
 *
 * All strips share one array of positions and one of colors. glMultiDrawArrays draws some of its runs,
 * glMultiDrawElements lists of elements; the arrays and elements may lie in buffer objects of the library.
 *
 *   b       arrays in buffer objects, or in the program's memory
 *   e       elements: glMultiDrawElements
 *   left, right   wave
 *
 * GL 1.5, 2.8 "Vertex Arrays", 2.9 "Buffer Objects".
 */
#define GL_GLEXT_PROTOTYPES
#include <GL/glut.h>

#include <math.h>

enum { RIBBONS = 9, COLUMNS = 40, RUN = 2 * COLUMNS };

static float position[RIBBONS * RUN][3];
static GLubyte color[RIBBONS * RUN][4];
static GLushort element[RIBBONS][RUN];
static GLint first[RIBBONS];
static GLsizei count[RIBBONS];
static GLuint buffer[3]; /* positions, colors, elements */
static int in_buffers = 1, by_elements;
static float phase;

static void make_flag(void)
{
    for (int r = 0; r < RIBBONS; r++) {
        first[r] = r * RUN;
        count[r] = RUN;
        for (int i = 0; i < RUN; i++) {
            const int v = r * RUN + i;
            const float x = 3.0f * (float)(i / 2) / (COLUMNS - 1) - 1.5f;
            const float y = ((float)r + 0.8f * (float)(i % 2)) / RIBBONS * 2 - 1;
            const float wave = sinf(4 * x + phase) * (x + 1.5f) / 3;
            position[v][0] = x;
            position[v][1] = y + 0.15f * wave;
            position[v][2] = 0.4f * wave;
            color[v][0] = (GLubyte)(200 - 15 * r);
            color[v][1] = (GLubyte)(70 + 18 * r);
            color[v][2] = (GLubyte)(140 + 90 * wave);
            color[v][3] = 255;
            element[r][i] = (GLushort)(v ^ 1); /* the ribbons' other side in front */
        }
    }
}

/* What glVertexPointer and the others are given: an offset into a buffer, or an address. */
static const void *place(GLenum target, GLuint name, const void *address)
{
    glBindBuffer(target, in_buffers ? name : 0);
    return in_buffers ? NULL : address;
}

static void fill_buffers(void)
{
    glBindBuffer(GL_ARRAY_BUFFER, buffer[0]);
    glBufferData(GL_ARRAY_BUFFER, sizeof position, position, GL_DYNAMIC_DRAW);
    glBindBuffer(GL_ARRAY_BUFFER, buffer[1]);
    glBufferData(GL_ARRAY_BUFFER, sizeof color, NULL, GL_DYNAMIC_DRAW);
    GLubyte *mapped = glMapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY);
    for (int i = 0; mapped && i < (int)sizeof color; i++)
        mapped[i] = color[i / 4][i % 4];
    glUnmapBuffer(GL_ARRAY_BUFFER);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer[2]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof element, element, GL_STATIC_DRAW);
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    make_flag();
    if (in_buffers)
        fill_buffers();
    glVertexPointer(3, GL_FLOAT, 0, place(GL_ARRAY_BUFFER, buffer[0], position));
    glColorPointer(4, GL_UNSIGNED_BYTE, 0, place(GL_ARRAY_BUFFER, buffer[1], color));
    const char *base = place(GL_ELEMENT_ARRAY_BUFFER, buffer[2], element);
    if (by_elements) {
        const void *list[RIBBONS];
        for (int r = 0; r < RIBBONS; r++)
            list[r] = base + (size_t)r * sizeof element[0];
        glMultiDrawElements(GL_TRIANGLE_STRIP, count, GL_UNSIGNED_SHORT, list, RIBBONS);
    } else {
        glMultiDrawArrays(GL_TRIANGLE_STRIP, first, count, RIBBONS);
    }
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(45, (double)width / height, 0.5, 20);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(0.8, 0.5, 3.2, 0, 0, 0, 0, 1, 0);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 'b')
        in_buffers = !in_buffers;
    if (key == 'e')
        by_elements = !by_elements;
    glutPostRedisplay();
}

static void special(int key, int x, int y)
{
    (void)x, (void)y;
    phase += key == GLUT_KEY_LEFT ? -0.5f : key == GLUT_KEY_RIGHT ? 0.5f : 0;
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(400, 300);
    glutCreateWindow("mvarray");
    glClearColor(0.10f, 0.11f, 0.14f, 1);
    glEnable(GL_DEPTH_TEST);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glGenBuffers(3, buffer);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutSpecialFunc(special);
    glutMainLoop();
    return 0;
}
