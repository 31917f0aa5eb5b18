/*
 * sprites: snow in perspective, each flake one point with a picture on it.
 *
 * GL_POINT_SPRITE_ARB makes a point a square; GL_COORD_REPLACE_ARB, of each texture unit, lets the texture
 * coordinates run over it: s from 0 at the left to 1, t from 0 at the top. What glTexCoord gives is not used.
 *
 *   r       coordinates replaced, or the vertices' own
 *   u       a second unit, which tints by a picture of its own
 *   s       sprites, or plain points
 *
 * GL_ARB_point_sprite; GL 1.5, 3.3 "Points".
 */
#define GL_GLEXT_PROTOTYPES
#include <GL/glut.h>

#include <math.h>

enum { FLAKES = 120, SIZE = 32 };

static int replaced = 1, tinted, sprites = 1;

/* 0 .. 1, from a linear congruence. */
static float next_random(unsigned *seed)
{
    *seed = *seed * 1103515245u + 12345u;
    return (float)(*seed >> 16 & 0x7fff) / 32767.0f;
}

/* A star of six points, with a mark at its upper right that shows which way is up. */
static void make_flake(GLuint texture)
{
    GLubyte image[SIZE][SIZE][4];
    for (int row = 0; row < SIZE; row++)
        for (int column = 0; column < SIZE; column++) {
            const float x = ((float)column + 0.5f) * 2 / SIZE - 1, y = ((float)row + 0.5f) * 2 / SIZE - 1;
            const float r = sqrtf(x * x + y * y), ray = cosf(6 * atan2f(y, x));
            const int inside = r < 0.45f + 0.45f * ray, mark = column > SIZE - 8 && row < 8;
            image[row][column][0] = (GLubyte)(mark ? 255 : 180);
            image[row][column][1] = (GLubyte)(mark ? 120 : 220);
            image[row][column][2] = (GLubyte)(mark ? 40 : 255);
            image[row][column][3] = (GLubyte)(inside || mark ? 255 - 200 * (int)(r * 10) / 15 : 0);
        }
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, SIZE, SIZE, 0, GL_RGBA, GL_UNSIGNED_BYTE, image);
}

/* From red at the upper left corner to green at the lower right. */
static void make_tint(GLuint texture)
{
    static const GLubyte image[4][3] = {{255, 90, 90}, {255, 255, 90}, {255, 255, 90}, {90, 255, 90}};
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 2, 2, 0, GL_RGB, GL_UNSIGNED_BYTE, image);
}

static void draw_flakes(void)
{
    unsigned seed = 7;
    glBegin(GL_POINTS);
    for (int i = 0; i < FLAKES; i++) {
        const float z = -12.0f + 0.09f * (float)i, spread = 0.7f * -(z - 2);
        glColor3f(1, 1, 0.7f + 0.3f * next_random(&seed));
        glTexCoord2f(next_random(&seed), 0.25f);
        const float x = spread * (next_random(&seed) - 0.5f);
        glVertex3f(x, spread * (next_random(&seed) - 0.5f), z);
    }
    glEnd();
}

static void use_unit(GLenum unit, int on)
{
    glActiveTexture(unit);
    (on ? glEnable : glDisable)(GL_TEXTURE_2D);
    glTexEnvi(GL_POINT_SPRITE_ARB, GL_COORD_REPLACE_ARB, replaced);
}

static void display(void)
{
    static const float falling_off[3] = {0, 0, 0.02f};
    glClear(GL_COLOR_BUFFER_BIT);
    glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, falling_off);
    glPointSize(20);
    (sprites ? glEnable : glDisable)(GL_POINT_SPRITE_ARB);
    use_unit(GL_TEXTURE0, 1);
    use_unit(GL_TEXTURE1, tinted);
    draw_flakes();
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(45, (double)width / height, 1, 20);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0, 0, -2);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 'r')
        replaced = !replaced;
    if (key == 'u')
        tinted = !tinted;
    if (key == 's')
        sprites = !sprites;
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    GLuint texture[2];
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB);
    glutInitWindowSize(400, 300);
    glutCreateWindow("sprites");
    glClearColor(0.05f, 0.08f, 0.2f, 1);
    glGenTextures(2, texture);
    make_flake(texture[0]);
    glActiveTexture(GL_TEXTURE1);
    make_tint(texture[1]);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
