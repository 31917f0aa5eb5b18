/*
 * bump: a flat wall that looks built of bricks. Its normals come from a texture, three numbers for each texel, and are
 * multiplied with the direction to the light by GL_DOT3_RGB.
 *
 * The program computes heights (bricks, mortar, roughness), from their differences the normals, and stores (x, y, z)
 * of each as red, green, blue, -1..1 as 0..1. The direction to the light, the same way, is the vertices' color;
 * interpolated, it is shorter between vertices than at them, so the wall is made of a few. Unit 1 multiplies the
 * result by the color of the bricks. No glNormal, no GL_LIGHTING.
 *
 *   arrows     move the light
 *   b          with and without bumps
 *   n          the normal map itself
 *
 * GL 1.5, 3.8.13 "Texture Environments and Texture Functions": GL_COMBINE; 2.7 "Vertex Specification": texture units.
 */
#define GL_GLEXT_PROTOTYPES
#include <GL/glut.h>

#include <math.h>

enum { SIZE = 256, BRICK_WIDTH = 64, BRICK_HEIGHT = 32, CELLS = 12 };

static GLuint normal_map, color_map;
static int light_x = -3, light_y = 3, bumps = 1, bare;

/* A number in [0,1) for each x, y: the same on every machine. */
static float noise(int x, int y)
{
    unsigned n = (unsigned)(x & (SIZE - 1)) * 73856093u ^ (unsigned)(y & (SIZE - 1)) * 19349663u;

    n = (n ^ n >> 13) * 1274126177u;
    return (float)(n >> 16 & 1023) / 1024;
}

static int brick_row(int y)
{
    return (y & (SIZE - 1)) / BRICK_HEIGHT;
}

/* Bricks of every other row are shifted by half. */
static int shifted(int x, int y)
{
    return (x + (brick_row(y) & 1) * BRICK_WIDTH / 2) & (SIZE - 1);
}

/* How far, in texels, from the brick's nearest edge. */
static int from_edge(int x, int y)
{
    const int u = shifted(x, y) % BRICK_WIDTH, v = (y & (SIZE - 1)) % BRICK_HEIGHT;
    const int across = u < BRICK_WIDTH - 1 - u ? u : BRICK_WIDTH - 1 - u;
    const int up = v < BRICK_HEIGHT - 1 - v ? v : BRICK_HEIGHT - 1 - v;

    return across < up ? across : up;
}

static float height(int x, int y)
{
    const int edge = from_edge(x, y);
    const float rough = noise(x / 2, y / 2) + noise(x / 4 + 99, y / 4);

    return (edge < 2 ? 0 : edge < 7 ? (float)(edge - 2) / 5 : 1) * 5 + 0.35f * rough;
}

static GLubyte to_byte(float v)
{
    return (GLubyte)(255 * (v * 0.5f + 0.5f) + 0.5f);
}

static void make_texture(GLuint name, const GLubyte texels[SIZE][SIZE][3])
{
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, SIZE, SIZE, 0, GL_RGB, GL_UNSIGNED_BYTE, texels);
}

static void make_normals(void)
{
    static GLubyte texels[SIZE][SIZE][3];

    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++) {
            const float dx = (height(x + 1, y) - height(x - 1, y)) / 2, dy = (height(x, y + 1) - height(x, y - 1)) / 2;
            const float length = sqrtf(dx * dx + dy * dy + 1);
            texels[y][x][0] = to_byte(-dx / length);
            texels[y][x][1] = to_byte(-dy / length);
            texels[y][x][2] = to_byte(1 / length);
        }
    make_texture(normal_map, texels);
}

static void make_colors(void)
{
    static GLubyte texels[SIZE][SIZE][3];

    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++) {
            const float shade = 0.75f + 0.25f * noise(shifted(x, y) / BRICK_WIDTH * 7, brick_row(y) * 5);
            const int mortar = from_edge(x, y) < 3;
            texels[y][x][0] = (GLubyte)(mortar ? 190 : 205 * shade);
            texels[y][x][1] = (GLubyte)(mortar ? 185 : 105 * shade);
            texels[y][x][2] = (GLubyte)(mortar ? 175 : 75 * shade);
        }
    make_texture(color_map, texels);
}

/* Unit 0: 4 ((n.x - 1/2)(l.x - 1/2) + ...), n from the texture or straight ahead. Unit 1: times the color map. */
static void set_environments(void)
{
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, normal_map);
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, bare ? GL_REPLACE : GL_COMBINE);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_DOT3_RGB);
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_RGB, bumps ? GL_TEXTURE : GL_CONSTANT);
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE1_RGB, GL_PRIMARY_COLOR);
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, (float[]){0.5f, 0.5f, 1, 1});
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, color_map);
    if (bare)
        glDisable(GL_TEXTURE_2D);
    else
        glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
}

/* A corner of the wall, which is 3 by 2 in the plane z = 0. */
static void corner(int i, int k)
{
    const float s = (float)i / CELLS, t = (float)k / CELLS, x = 3 * s - 1.5f, y = 2 * t - 1;
    const float lx = 0.3f * (float)light_x - x, ly = 0.3f * (float)light_y - y, lz = 0.7f;
    const float length = sqrtf(lx * lx + ly * ly + lz * lz);

    glColor3f(lx / length * 0.5f + 0.5f, ly / length * 0.5f + 0.5f, lz / length * 0.5f + 0.5f);
    glMultiTexCoord2f(GL_TEXTURE0, 1.5f * s, t);
    glMultiTexCoord2f(GL_TEXTURE1, 1.5f * s, t);
    glVertex3f(x, y, 0);
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT);
    set_environments();
    for (int k = 0; k < CELLS; k++) {
        glBegin(GL_QUAD_STRIP);
        for (int i = 0; i <= CELLS; i++) {
            corner(i, k + 1);
            corner(i, k);
        }
        glEnd();
    }
    glFlush();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(40, (double)width / height, 1, 10);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(1, 0.2, 3.6, 0.1, 0, 0, 0, 1, 0);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 'b')
        bumps = !bumps;
    else if (key == 'n')
        bare = !bare;
    glutPostRedisplay();
}

static void special(int key, int x, int y)
{
    (void)x, (void)y;
    light_x += key == GLUT_KEY_RIGHT ? 1 : key == GLUT_KEY_LEFT ? -1 : 0;
    light_y += key == GLUT_KEY_UP ? 1 : key == GLUT_KEY_DOWN ? -1 : 0;
    glutPostRedisplay();
}

static void init(void)
{
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glGenTextures(1, &normal_map);
    glGenTextures(1, &color_map);
    make_normals();
    make_colors();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_SINGLE | GLUT_RGB);
    glutInitWindowSize(600, 400);
    glutCreateWindow("bump");
    init();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutSpecialFunc(special);
    glutMainLoop();
    return 0;
}
