/*
 * stroke: an alphabet of lines, written with one call.
 *
 * Each letter is a display list that draws its strokes and moves on by its width. glCallLists runs a whole
 * string of them, the list base added to each character. As lines the letters can be turned, scaled and
 * sheared.
 *
 *   t   tilt the lines of text more
 *   + - thickness
 *
 * GL 1.5, 5.4 "Display Lists" (glListBase, glCallLists).
 */
#include <GL/glut.h>
#include <string.h>

enum { ADVANCE = 6 };

/* Strokes on a grid of 5 by 7 points, each point an x and a y; a blank lifts the pen. */
static const struct {
    char letter;
    const char *strokes;
} alphabet[] = {{'A', "0004264440 0242"},
                {'E', "40000646 0333"},
                {'G', "45361605011030414323"},
                {'I', "2026"},
                {'L', "060040"},
                {'N', "00064046"},
                {'R', "00063645443303 2340"},
                {'S', "4536160514344341301001"},
                {'T', "0646 2620"},
                {' ', ""}};

static int tilt, base;
static float thickness = 2;

static void draw_strokes(const char *point)
{
    glBegin(GL_LINE_STRIP);
    for (; *point; point++)
        if (*point == ' ') {
            glEnd();
            glBegin(GL_LINE_STRIP);
        } else {
            glVertex2i(point[0] - '0', point[1] - '0');
            point++;
        }
    glEnd();
}

static void make_letters(void)
{
    base = (int)glGenLists(128);
    for (size_t i = 0; i < sizeof alphabet / sizeof *alphabet; i++) {
        glNewList((GLuint)(base + alphabet[i].letter), GL_COMPILE);
        draw_strokes(alphabet[i].strokes);
        glTranslatef(ADVANCE, 0, 0);
        glEndList();
    }
    glListBase((GLuint)base);
}

static void write_line(const char *text, float y, float size)
{
    glPushMatrix();
    glTranslatef(0, y, 0);
    glRotatef((float)tilt, 0, 0, 1);
    glScalef(size, size, 1);
    glTranslatef(-0.5f * (float)(ADVANCE * (int)strlen(text) - 2), -3, 0);
    glCallLists((GLsizei)strlen(text), GL_UNSIGNED_BYTE, text);
    glPopMatrix();
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT);
    glLineWidth(2 * thickness);
    glColor3f(0.95f, 0.75f, 0.35f);
    write_line("A LINE", 55, 7);
    glLineWidth(thickness);
    glColor3f(0.55f, 0.80f, 0.90f);
    write_line("IS A LETTER", -15, 4);
    glColor3f(0.75f, 0.55f, 0.85f);
    write_line("IS A LINE AGAIN", -70, 2.8f);
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluOrtho2D(-160, 160, -120, 120);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 't')
        tilt += 5;
    thickness += 0.5f * (float)((key == '+') - (key == '-'));
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB);
    glutInitWindowSize(320, 240);
    glutCreateWindow("stroke");
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glEnable(GL_LINE_SMOOTH);
    make_letters();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
