/*
 * font: a board of lamps that shows text.
 *
 * Each letter is a display list of one glBitmap, made from five by seven dots that become lamps of two by two
 * pixels. A string is one glCallLists; the raster position moves on by itself.
 *
 *   left, right   move the text, beyond the edges too
 *
 * GL 1.5, 3.7 "Bitmaps" and 5.4 "Display Lists" (glListBase, glCallLists).
 */
#include <GL/glut.h>
#include <string.h>

enum { DOT = 3, COLUMNS = 5, ROWS = 7, ADVANCE = 6 * DOT };

/* A to Z: seven rows of five dots, the highest first. */
static const GLubyte dots[26][ROWS] = {
        {14, 17, 17, 31, 17, 17, 17}, {30, 17, 17, 30, 17, 17, 30}, {14, 17, 16, 16, 16, 17, 14},
        {30, 17, 17, 17, 17, 17, 30}, {31, 16, 16, 30, 16, 16, 31}, {31, 16, 16, 30, 16, 16, 16},
        {14, 17, 16, 23, 17, 17, 14}, {17, 17, 17, 31, 17, 17, 17}, {14, 4, 4, 4, 4, 4, 14},
        {7, 2, 2, 2, 2, 18, 12},      {17, 18, 20, 24, 20, 18, 17}, {16, 16, 16, 16, 16, 16, 31},
        {17, 27, 21, 21, 17, 17, 17}, {17, 25, 25, 21, 19, 19, 17}, {14, 17, 17, 17, 17, 17, 14},
        {30, 17, 17, 30, 16, 16, 16}, {14, 17, 17, 17, 21, 18, 13}, {30, 17, 17, 30, 20, 18, 17},
        {15, 16, 16, 14, 1, 1, 30},   {31, 4, 4, 4, 4, 4, 4},       {17, 17, 17, 17, 17, 17, 14},
        {17, 17, 17, 17, 17, 10, 4},  {17, 17, 17, 21, 21, 27, 17}, {17, 17, 10, 4, 10, 17, 17},
        {17, 17, 10, 4, 4, 4, 4},     {31, 1, 2, 4, 8, 16, 31}};
static int shift; /* pixels */

static void make_letter(GLuint list, const GLubyte *rows)
{
    GLubyte bitmap[ROWS * DOT][2] = {{0}};

    for (int y = 0; y < ROWS * DOT; y++)
        for (int x = 0; x < COLUMNS * DOT; x++)
            if (rows[ROWS - 1 - y / DOT] & 16 >> x / DOT && x % DOT < 2 && y % DOT < 2)
                bitmap[y][x / 8] = (GLubyte)(bitmap[y][x / 8] | 0x80 >> x % 8);
    glNewList(list, GL_COMPILE);
    glBitmap(COLUMNS * DOT, ROWS * DOT, 0, 0, ADVANCE, 0, &bitmap[0][0]);
    glEndList();
}

static void make_letters(void)
{
    const GLuint base = glGenLists(128);

    for (GLuint i = 0; i < 26; i++)
        make_letter(base + 'A' + i, dots[i]);
    glNewList(base + ' ', GL_COMPILE);
    glBitmap(0, 0, 0, 0, ADVANCE, 0, dots[0]); /* nothing to draw: only a move */
    glEndList();
    glListBase(base);
}

/* A raster position outside of the window is invalid and draws nothing: start inside and move by a bitmap. */
static void write_line(const char *text, int x, int y)
{
    glRasterPos2i(0, y);
    glBitmap(0, 0, 0, 0, (float)(x + shift), 0, NULL);
    glCallLists((GLsizei)strlen(text), GL_UNSIGNED_BYTE, text);
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT);
    glColor3f(1, 0.70f, 0.20f);
    write_line("WALTZ BAD NYMPH", 25, 190);
    glColor3f(0.95f, 0.35f, 0.25f);
    write_line("FOR QUICK JIGS", 34, 155);
    glColor3f(0.40f, 0.85f, 0.50f);
    write_line("VEX NO ONE", 70, 120);
    glColor3f(0.40f, 0.65f, 0.95f);
    write_line("ABCDEFGHIJKLM", 43, 65);
    write_line("NOPQRSTUVWXYZ", 43, 30);
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluOrtho2D(0, width, 0, height);
}

static void special(int key, int x, int y)
{
    (void)x, (void)y;
    shift += 10 * ((key == GLUT_KEY_RIGHT) - (key == GLUT_KEY_LEFT));
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB);
    glutInitWindowSize(320, 240);
    glutCreateWindow("font");
    glClearColor(0.07f, 0.07f, 0.09f, 1);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    make_letters();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutSpecialFunc(special);
    glutMainLoop();
    return 0;
}
