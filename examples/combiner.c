/*
 * combiner: the functions of GL_COMBINE, one on each square.
 *
 * Every square has the same texture, the same colors at its corners and the same constant color. Rows from
 * above: replace, modulate, add, add signed; interpolate, subtract, dot product, modulate scaled by 2. The
 * dot product takes the texture's colors for directions and the constant color for that of a light.
 *
 *   o   the second argument complemented
 *
 * GL 1.5, 3.8.13 "Texture Environments and Texture Functions".
 */
#include <GL/glut.h>

enum { SIZE = 32, SQUARES = 8, COLUMNS = 4 };

static int complemented;

/* Red and green grow along s and t as the x and y of a bump's normals do; blue is what is left of a unit of length, roughly. */
static void make_texture(void)
{
    static GLubyte image[SIZE][SIZE][4];
    for (int t = 0; t < SIZE; t++)
        for (int s = 0; s < SIZE; s++) {
            const int x = 2 * s - SIZE + 1, y = 2 * t - SIZE + 1, square = x * x + y * y;
            image[t][s][0] = (GLubyte)(128 + x * 4);
            image[t][s][1] = (GLubyte)(128 + y * 4);
            image[t][s][2] = (GLubyte)(square < SIZE * SIZE ? 255 - square / 9 : 128);
            image[t][s][3] = (GLubyte)((t / 4 + s / 4) % 2 ? 230 : 60);
        }
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, SIZE, SIZE, 0, GL_RGBA, GL_UNSIGNED_BYTE, image);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

static void set_combiner(int number)
{
    static const GLenum functions[SQUARES] = {GL_REPLACE,     GL_MODULATE, GL_ADD,      GL_ADD_SIGNED,
                                              GL_INTERPOLATE, GL_SUBTRACT, GL_DOT3_RGB, GL_MODULATE};
    const GLenum function = functions[number];
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, (int)function);
    glTexEnvi(GL_TEXTURE_ENV, GL_SRC0_RGB, GL_TEXTURE);
    glTexEnvi(GL_TEXTURE_ENV, GL_SRC1_RGB, function == GL_DOT3_RGB ? GL_CONSTANT : GL_PRIMARY_COLOR);
    glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND1_RGB, complemented ? GL_ONE_MINUS_SRC_COLOR : GL_SRC_COLOR);
    glTexEnvi(GL_TEXTURE_ENV, GL_SRC2_RGB, GL_TEXTURE);
    glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND2_RGB, GL_SRC_ALPHA);
    glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, number == SQUARES - 1 ? 2 : 1);
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, (float[]){0.85f, 0.75f, 0.80f, 1});
}

static void square(float x, float y)
{
    glBegin(GL_QUADS);
    glColor3f(0.9f, 0.2f, 0.1f);
    glTexCoord2f(0, 0);
    glVertex2f(x, y);
    glColor3f(0.2f, 0.8f, 0.3f);
    glTexCoord2f(1, 0);
    glVertex2f(x + 1, y);
    glColor3f(0.2f, 0.3f, 0.9f);
    glTexCoord2f(1, 1);
    glVertex2f(x + 1, y + 1);
    glColor3f(0.9f, 0.9f, 0.5f);
    glTexCoord2f(0, 1);
    glVertex2f(x, y + 1);
    glEnd();
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT);
    for (int i = 0; i < SQUARES; i++) {
        set_combiner(i);
        square(0.1f + 1.1f * (float)(i % COLUMNS), i < COLUMNS ? 1.2f : 0.1f);
    }
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluOrtho2D(0, 4.5, 0, 2.3);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 'o')
        complemented = !complemented;
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB);
    glutInitWindowSize(450, 230);
    glutCreateWindow("combiner");
    glEnable(GL_TEXTURE_2D);
    make_texture();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
