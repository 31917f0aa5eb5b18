/*
 * extremes: sixteen spheres, each lit under another extreme.
 *
 * Most extremes are another way to say the same scene: everything very small, a direction very long, normals
 * to be normalized from next to nothing. The picture should not change. For the others the specification has
 * an answer that is easily missed: a spot whose cone ends exactly at a vertex, attenuation 0, 0 to the power
 * 0. What arithmetic in float makes of them can be seen where a sphere does not look like the first.
 *
 *   left, right   one sphere alone, large; the first picture is all of them
 *
 * GL 1.5, 2.11.3 "Normal Transformation", 2.14.1 "Lighting".
 */
#include <GL/glut.h>
#include <math.h>

enum { COLUMNS = 4, ROWS = 4, SLICES = 48, STACKS = 32 };

static const double pi = 3.14159265358979324;

static int alone; /* 0: all */

/* What differs between the spheres; 0 where nothing is said. */
struct extreme {
    double size;                /* of the whole scene, distances included */
    double scale;               /* of the modelview matrix; the sphere is as much smaller in object space */
    double direction;           /* length of the vector to a light that is a direction */
    double normal;              /* length of normals */
    double w;                   /* of vertices */
    double stretch;             /* object space is so much longer in y */
    int normalize;              /* GL_NORMALIZE or GL_RESCALE_NORMAL */
    int flat, dull, near, spot; /* z axis scaled to 0; shininess 0, attenuated; attenuation 0; cone of 90
                                   degrees, whose edge is the equator */
};

static const struct extreme extremes[COLUMNS * ROWS] = {
        {0},
        {.size = 1e-22},
        {.size = 1e20},
        {.near = 1},
        {.direction = 1e-30},
        {.direction = 1e25},
        {.normal = 1e-25, .normalize = GL_NORMALIZE},
        {.normal = 1e-42, .normalize = GL_NORMALIZE},
        {.scale = 1e-22, .normalize = GL_NORMALIZE},
        {.scale = 1e8, .normalize = GL_RESCALE_NORMAL},
        {.stretch = 1e-9, .normalize = GL_NORMALIZE},
        {.flat = 1, .normalize = GL_NORMALIZE},
        {.w = 5},
        {.w = -1},
        {.dull = 1},
        {.spot = 1},
};

static double or_one(double x)
{
    return x == 0 ? 1 : x;
}

static void put_vertex(const struct extreme *e, int stack, int slice)
{
    const double latitude = pi * (stack - STACKS / 2) / STACKS, longitude = 2 * pi * slice / SLICES;
    const double n[3] = {cos(latitude) * cos(longitude), sin(latitude), cos(latitude) * sin(longitude)};
    const double size = or_one(e->size) / or_one(e->scale), w = or_one(e->w), y = or_one(e->stretch);
    const double length = or_one(e->normal);
    glNormal3f((float)(length * n[0]), (float)(length * n[1] / y), (float)(length * n[2]));
    glVertex4f((float)(size * n[0] * w), (float)(size * n[1] * y * w), (float)(size * n[2] * w), (float)w);
}

static void draw_sphere(const struct extreme *e)
{
    for (int stack = 0; stack < STACKS; stack++) {
        glBegin(GL_TRIANGLE_STRIP);
        for (int slice = 0; slice <= SLICES; slice++) {
            put_vertex(e, stack, slice);
            put_vertex(e, stack + 1, slice);
        }
        glEnd();
    }
}

static void place_light(const struct extreme *e)
{
    const double size = or_one(e->size), d = or_one(e->direction);
    const float w = e->direction == 0 ? 1 : 0;
    const double place[3] = {-1.6, e->spot ? 0 : 1.6, 1.5};
    float position[4] = {0, 0, 0, w};
    for (int i = 0; i < 3; i++)
        position[i] = (float)(place[i] * (w == 0 ? d : size));
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glLightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, e->near ? 0 : 1);
    glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, e->dull ? 0.2f : 0);
    glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, (float[]){0, 1, 0});
    glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, e->spot ? 90 : 180);
}

/* The lights are placed in eye space; then the sphere is moved 4 away, in its own measure. */
static void set_matrices(const struct extreme *e)
{
    const double size = or_one(e->size), scale = or_one(e->scale);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    if (e->w <
        0) /* the same in homogeneous coordinates: w, negative in eye space, is positive in clip space */
        glMultMatrixf((float[]){-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1});
    glOrtho(-1.15 * size, 1.15 * size, -1.15 * size, 1.15 * size, 2 * size, 6 * size);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    place_light(e);
    glTranslated(0, 0, -4 * size);
    glScaled(scale, scale / or_one(e->stretch), e->flat ? 0 : scale);
}

static void draw_extreme(const struct extreme *e)
{
    set_matrices(e);
    if (e->normalize)
        glEnable(e->normalize);
    glMaterialf(GL_FRONT, GL_SHININESS, e->dull ? 0 : 24);
    draw_sphere(e);
    glDisable(GL_NORMALIZE);
    glDisable(GL_RESCALE_NORMAL);
}

static void display(void)
{
    const int width = glutGet(GLUT_WINDOW_WIDTH), height = glutGet(GLUT_WINDOW_HEIGHT);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (int i = 0; i < COLUMNS * ROWS; i++) {
        const int w = width / COLUMNS, h = height / ROWS;
        if (alone)
            glViewport(0, 0, width, height);
        else
            glViewport(i % COLUMNS * w, (ROWS - 1 - i / COLUMNS) * h, w, h);
        if (!alone || alone == i + 1)
            draw_extreme(&extremes[i]);
    }
    glFlush();
}

static void special(int key, int x, int y)
{
    const int pictures = COLUMNS * ROWS + 1;
    (void)x, (void)y;
    if (key == GLUT_KEY_RIGHT)
        alone = (alone + 1) % pictures;
    else if (key == GLUT_KEY_LEFT)
        alone = (alone + pictures - 1) % pictures;
    glutPostRedisplay();
}

static void init(void)
{
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (float[]){0.20f, 0.45f, 0.75f, 1});
    glMaterialfv(GL_FRONT, GL_SPECULAR, (float[]){0.7f, 0.7f, 0.6f, 1});
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_CULL_FACE);
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_SINGLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(480, 480);
    glutCreateWindow("extremes");
    init();
    glutDisplayFunc(display);
    glutSpecialFunc(special);
    glutMainLoop();
    return 0;
}
