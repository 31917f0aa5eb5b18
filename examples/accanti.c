/*
 * accanti: a picture without steps, as the mean of many.
 *
 * The scene is drawn several times, each time moved by a fraction of a pixel, and the accumulation buffer
 * takes the mean. The projection is parallel, so the move is the same for everything: a translation in
 * normalized device coordinates, where a pixel is 2 / width wide.
 *
 *   + -   twice, half as many pictures
 *
 * GL 1.5, 4.2.4 "The Accumulation Buffer".
 */
#include <GL/glut.h>

static int samples = 8;

static void set_color(float red, float green, float blue)
{
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (float[]){red, green, blue, 1});
}

/* A stair of cubes, highest in the corner. */
static void draw_stair(void)
{
    for (int x = 0; x < 4; x++)
        for (int z = 0; z < 4 - x; z++)
            for (int y = 0; y < 4 - x - z; y++) {
                set_color(0.95f - 0.10f * (float)y, 0.45f + 0.09f * (float)x, 0.30f + 0.12f * (float)z);
                glPushMatrix();
                glTranslatef((float)x, (float)y, (float)z);
                glutSolidCube(0.94);
                glPopMatrix();
            }
}

/* The i-th of n points spread over the square of -1/2 to 1/2: one in each row and one in each column. */
static void get_sample(int i, int n, float *x, float *y)
{
    *x = ((float)i + 0.5f) / (float)n - 0.5f;
    *y = -0.5f + 0.5f / (float)n;
    for (float half = 0.5f; i > 0; i /= 2, half /= 2)
        *y += half * (float)(i % 2);
}

static void set_projection(float x, float y)
{
    GLint viewport[4];

    glGetIntegerv(GL_VIEWPORT, viewport);
    const float width = (float)viewport[2], height = (float)viewport[3];
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glTranslatef(2 * x / width, 2 * y / height, 0);
    glOrtho((double)(-3.2f * width / height), (double)(3.2f * width / height), -3.2, 3.2, 1, 20);
    glMatrixMode(GL_MODELVIEW);
}

static void display(void)
{
    glClear(GL_ACCUM_BUFFER_BIT);
    for (int i = 0; i < samples; i++) {
        float x, y;
        get_sample(i, samples, &x, &y);
        set_projection(x, y);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        draw_stair();
        glAccum(GL_ACCUM, 1 / (float)samples);
    }
    glAccum(GL_RETURN, 1);
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glLoadIdentity();
    gluLookAt(7, 6, 7, 0.85, 1.05, 0.85, 0, 1, 0);
    glLightfv(GL_LIGHT0, GL_POSITION, (float[]){0.4f, 2, 1.2f, 0});
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == '+' && samples < 64)
        samples *= 2;
    if (key == '-' && samples > 1)
        samples /= 2;
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH | GLUT_ACCUM);
    glutInitWindowSize(320, 240);
    glutCreateWindow("accanti");
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
