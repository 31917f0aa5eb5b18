/*
 * tess: polygons that GL cannot draw as they are.
 *
 * GL's polygons are convex. GLU cuts others into triangles: here a letter with a hole, and a star whose edges
 * cross, so that a vertex has to be made at each crossing, with the color mixed from its neighbors. Both are
 * put into display lists.
 *
 *   e   edges of the original polygon, or filled
 *
 * GLU 1.3, chapter 5 "Polygon Tessellation"; GL 1.5, 2.6.2 "Polygon Edges" and 5.4.
 */
#include <GL/glut.h>
#include <math.h>
#include <stdlib.h>

enum { LETTER = 1, STAR = 2, MAX_MADE = 64 };

/* What a tessellated vertex is: place and color. */
struct vertex {
    GLdouble place[3], color[3];
};

static struct vertex made[MAX_MADE]; /* at crossings; needed until gluTessEndPolygon */
static int made_count;
static GLboolean edges;

static void emit(void *data)
{
    const struct vertex *v = data;

    glColor3dv(v->color);
    glVertex3dv(v->place);
}

static void combine(GLdouble place[3], void *neighbors[4], GLfloat weight[4], void **result)
{
    struct vertex *v = &made[made_count++ % MAX_MADE];

    for (int i = 0; i < 3; i++) {
        v->place[i] = place[i];
        v->color[i] = 0;
        for (int k = 0; k < 4; k++)
            if (neighbors[k])
                v->color[i] += (GLdouble)weight[k] * ((struct vertex *)neighbors[k])->color[i];
    }
    *result = v;
}

static void fail(GLenum error)
{
    (void)error;
    exit(1);
}

static void add_contour(GLUtesselator *tess, struct vertex *v, int n)
{
    gluTessBeginContour(tess);
    for (int i = 0; i < n; i++)
        gluTessVertex(tess, v[i].place, &v[i]);
    gluTessEndContour(tess);
}

static void make_letter(GLUtesselator *tess)
{
    static struct vertex outer[] = {{{-1.7, -1, 0}, {0.9, 0.4, 0.3}},    {{-1.3, -1, 0}, {0.9, 0.4, 0.3}},
                                    {{-1.18, -0.5, 0}, {0.9, 0.6, 0.3}}, {{-0.62, -0.5, 0}, {0.9, 0.6, 0.3}},
                                    {{-0.5, -1, 0}, {0.9, 0.4, 0.3}},    {{-0.1, -1, 0}, {0.9, 0.4, 0.3}},
                                    {{-0.7, 1, 0}, {0.95, 0.9, 0.4}},    {{-1.1, 1, 0}, {0.95, 0.9, 0.4}}};
    static struct vertex hole[] = {{{-1.1, -0.15, 0}, {0.9, 0.7, 0.3}},
                                   {{-0.7, -0.15, 0}, {0.9, 0.7, 0.3}},
                                   {{-0.9, 0.6, 0}, {0.95, 0.85, 0.4}}};

    glNewList(LETTER, GL_COMPILE);
    gluTessProperty(tess, GLU_TESS_WINDING_RULE, GLU_TESS_WINDING_ODD);
    gluTessBeginPolygon(tess, NULL);
    add_contour(tess, outer, 8);
    add_contour(tess, hole, 3);
    gluTessEndPolygon(tess);
    glEdgeFlag(GL_TRUE); /* the current value again */
    glEndList();
}

static void make_star(GLUtesselator *tess)
{
    static struct vertex tips[7];

    for (int i = 0; i < 7; i++) {
        const double angle =
                6.283185307179586 * (3 * i % 7) / 7 + 1.5707963267948966; /* every third of seven tips */
        tips[i] = (struct vertex){{0.95 + 0.85 * cos(angle), 0.95 * sin(angle), 0},
                                  {0.2, 0.3 + 0.1 * i, 0.95 - 0.1 * i}};
    }
    glNewList(STAR, GL_COMPILE);
    gluTessProperty(tess, GLU_TESS_WINDING_RULE, GLU_TESS_WINDING_NONZERO);
    gluTessBeginPolygon(tess, NULL);
    add_contour(tess, tips, 7);
    gluTessEndPolygon(tess);
    glEdgeFlag(GL_TRUE); /* the current value again */
    glEndList();
}

static void make_lists(void)
{
    GLUtesselator *tess = gluNewTess();

    gluTessCallback(tess, GLU_TESS_BEGIN, (_GLUfuncptr)glBegin);
    gluTessCallback(tess, GLU_TESS_END, (_GLUfuncptr)glEnd);
    gluTessCallback(tess, GLU_TESS_EDGE_FLAG, (_GLUfuncptr)glEdgeFlag);
    gluTessCallback(tess, GLU_TESS_VERTEX, (_GLUfuncptr)emit);
    gluTessCallback(tess, GLU_TESS_COMBINE, (_GLUfuncptr)combine);
    gluTessCallback(tess, GLU_TESS_ERROR, (_GLUfuncptr)fail);
    make_letter(tess);
    make_star(tess);
    gluDeleteTess(tess);
}

static void draw_ground(void)
{
    glColor3f(0.4f, 0.42f, 0.47f);
    glBegin(GL_LINES);
    glVertex2f(-1.9f, -1.1f);
    glVertex2f(1.9f, -1.1f);
    glEnd();
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT);
    glPolygonMode(GL_FRONT_AND_BACK, edges ? GL_LINE : GL_FILL);
    draw_ground();
    glCallList(LETTER);
    glCallList(STAR);
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluOrtho2D(-2, 2, -1.25, 1.25);
    glMatrixMode(GL_MODELVIEW);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 'e')
        edges = !edges;
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB);
    glutInitWindowSize(560, 350);
    glutCreateWindow("tess");
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glLineWidth(2);
    make_lists();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
