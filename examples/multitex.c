/*
 * multitex: two textures on one square, the second a lamp's light.
 *
 * Unit 0 has bricks, which the color modulates; unit 1 modulates the result with a soft spot, its own
 * coordinates moved by its own texture matrix. What comes out of one unit goes into the next.
 *
 *   0 1          units on and off
 *   a            unit 1 modulates or adds
 *   arrows       move the light
 *
 * GL 1.5, 3.8.15 "Texture Application", 2.7 (glMultiTexCoord).
 */
#define GL_GLEXT_PROTOTYPES
#include <GL/glut.h>

enum { SIZE = 64 };

static int unit_on[2] = {1, 1}, adds;
static float light_x, light_y;

static void make_bricks(void)
{
    static GLubyte image[SIZE][SIZE][3];
    for (int t = 0; t < SIZE; t++)
        for (int s = 0; s < SIZE; s++) {
            const int joint = t % 16 < 2 || (s + t / 16 % 2 * 16) % 32 < 2;
            image[t][s][0] = (GLubyte)(joint ? 200 : 168 + (s * 5 + t * 11) % 24);
            image[t][s][1] = (GLubyte)(joint ? 196 : 84 + (s * 3 + t * 7) % 16);
            image[t][s][2] = (GLubyte)(joint ? 186 : 62);
        }
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, SIZE, SIZE, 0, GL_RGB, GL_UNSIGNED_BYTE, image);
}

static void make_light(void)
{
    static GLubyte image[SIZE][SIZE];
    for (int t = 0; t < SIZE; t++)
        for (int s = 0; s < SIZE; s++) {
            const int x = 2 * s - SIZE + 1, y = 2 * t - SIZE + 1, left = SIZE * SIZE - x * x - y * y;
            image[t][s] = (GLubyte)(left > 0 ? 36 + left * 219 / (SIZE * SIZE) : 36);
        }
    glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, SIZE, SIZE, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, image);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

static void make_textures(void)
{
    GLuint names[2];
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glGenTextures(2, names);
    for (GLenum unit = 0; unit < 2; unit++) {
        glActiveTexture(GL_TEXTURE0 + unit);
        glBindTexture(GL_TEXTURE_2D, names[unit]);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        if (unit == 0)
            make_bricks();
        else
            make_light();
    }
}

static void corner(float x, float y)
{
    glMultiTexCoord2f(GL_TEXTURE0, 2 * x, 2 * y);
    glMultiTexCoord2f(GL_TEXTURE1, x, y);
    glVertex3f(3 * x - 1.5f, 2 * y - 1, -1.2f * x);
}

static void set_units(void)
{
    for (int unit = 0; unit < 2; unit++) {
        glActiveTexture(GL_TEXTURE0 + (GLenum)unit);
        if (unit_on[unit])
            glEnable(GL_TEXTURE_2D);
        else
            glDisable(GL_TEXTURE_2D);
    }
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, adds ? GL_ADD : GL_MODULATE);
    glMatrixMode(GL_TEXTURE);
    glLoadIdentity();
    glTranslatef(0.5f - light_x, 0.5f - light_y, 0);
    glScalef(1.4f, 1.4f, 1);
    glTranslatef(-0.5f, -0.5f, 0);
    glMatrixMode(GL_MODELVIEW);
}

static void display(void)
{
    set_units();
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glColor3f(1, 0.97f, 0.90f);
    glBegin(GL_QUADS);
    corner(0, 0);
    corner(1, 0);
    corner(1, 1);
    corner(0, 1);
    glEnd();
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
    glTranslatef(0, 0, -2.6f);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == '0' || key == '1')
        unit_on[key - '0'] = !unit_on[key - '0'];
    if (key == 'a')
        adds = !adds;
    glutPostRedisplay();
}

static void special(int key, int x, int y)
{
    (void)x, (void)y;
    light_x += key == GLUT_KEY_RIGHT ? 0.125f : key == GLUT_KEY_LEFT ? -0.125f : 0;
    light_y += key == GLUT_KEY_UP ? 0.125f : key == GLUT_KEY_DOWN ? -0.125f : 0;
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(320, 240);
    glutCreateWindow("multitex");
    glEnable(GL_DEPTH_TEST);
    make_textures();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutSpecialFunc(special);
    glutMainLoop();
    return 0;
}
