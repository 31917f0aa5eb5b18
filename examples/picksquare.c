/*
 * picksquare: which square was clicked?
 *
 * In selection mode nothing is drawn; instead every named object that would have touched the view volume is
 * reported. gluPickMatrix makes that volume a few pixels wide around the mouse. Each square has two names:
 * its row and, on top of it on the name stack, its column.
 *
 *   left button   next color for the squares under the mouse; their names are printed
 *
 * GL 1.5, 5.2 "Selection".
 */
#include <GL/glut.h>
#include <stdio.h>

enum { SIDE = 4, PALETTE = 5 };

static const float palette[PALETTE][3] = {{0.22f, 0.24f, 0.30f},
                                          {0.85f, 0.35f, 0.25f},
                                          {0.9f, 0.75f, 0.3f},
                                          {0.35f, 0.7f, 0.45f},
                                          {0.3f, 0.5f, 0.85f}};
static int board[SIDE][SIDE];

static void draw_squares(void)
{
    for (int row = 0; row < SIDE; row++) {
        glPushName((GLuint)row);
        glPushName(0);
        for (int column = 0; column < SIDE; column++) {
            glLoadName((GLuint)column);
            glColor3fv(palette[board[row][column]]);
            glRectf((float)column + 0.04f, (float)row + 0.04f, (float)column + 0.96f, (float)row + 0.96f);
        }
        glPopName();
        glPopName();
    }
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT);
    draw_squares();
    glutSwapBuffers();
}

static void set_projection(void)
{
    gluOrtho2D(0, SIDE, 0, SIDE);
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    set_projection();
    glMatrixMode(GL_MODELVIEW);
}

static void recolor(const GLuint *hits, int n)
{
    for (int i = 0; i < n; i++, hits += 5) { /* two names, two depths, the names */
        const GLuint row = hits[3], column = hits[4];
        printf("row %u, column %u\n", row, column);
        board[row][column] = (board[row][column] + 1) % PALETTE;
    }
}

static void mouse(int button, int state, int x, int y)
{
    GLuint hits[5 * SIDE * SIDE];
    GLint viewport[4];

    if (button != GLUT_LEFT_BUTTON || state != GLUT_DOWN)
        return;
    glGetIntegerv(GL_VIEWPORT, viewport);
    glSelectBuffer(5 * SIDE * SIDE, hits);
    glRenderMode(GL_SELECT);
    glInitNames();
    glMatrixMode(GL_PROJECTION);
    glPushMatrix();
    glLoadIdentity();
    gluPickMatrix(x, viewport[3] - y, 12, 12, viewport);
    set_projection();
    draw_squares();
    glPopMatrix();
    glMatrixMode(GL_MODELVIEW);
    recolor(hits, glRenderMode(GL_RENDER));
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB);
    glutInitWindowSize(300, 300);
    glutCreateWindow("picksquare");
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutMouseFunc(mouse);
    glutMainLoop();
    return 0;
}
