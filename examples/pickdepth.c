/*
 * pickdepth: of several objects under the mouse, the nearest.
 *
 * A hit record says how near and how far its object is within the pick volume, as a fraction of 2^32 - 1.
 * Cards overlap here; the card with the least depth under the mouse is lifted out of the stack, and all hits
 * are printed.
 *
 *   left button    lift a card, or put it back
 *   right button   put all cards back
 *
 * GL 1.5, 5.2 "Selection"; 2.11.1 "Controlling the Viewport" for depth.
 */
#include <GL/glut.h>
#include <stdio.h>

enum { CARDS = 6 };

static GLboolean lifted[CARDS];

static void draw_card(int i)
{
    const float t = (float)i / (CARDS - 1);

    glPushMatrix();
    glTranslatef(1.3f * t - 0.65f, lifted[i] ? 0.45f : -0.1f, 0.8f - 1.6f * t);
    glRotatef(20 - 40 * t, 0, 0, 1);
    glColor3f(0.95f - 0.6f * t, 0.35f + 0.3f * t, 0.3f + 0.6f * t);
    glRectf(-0.28f, -0.42f, 0.28f, 0.42f);
    glColor3f(0.95f, 0.95f, 0.9f);
    glTranslatef(0, 0, 0.01f);
    glRectf(-0.22f, 0.2f, -0.1f, 0.36f);
    glPopMatrix();
}

static void draw_cards(void)
{
    for (int i = 0; i < CARDS; i++) {
        glLoadName((GLuint)i);
        draw_card(i);
    }
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw_cards();
    glutSwapBuffers();
}

static void set_projection(void)
{
    glOrtho(-1.2, 1.2, -1.2, 1.2, -1, 1);
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    set_projection();
    glMatrixMode(GL_MODELVIEW);
}

/* The card of the record with the least depth, -1 without records. Records are 4 values: a count of 1, two
 * depths, the name. */
static int nearest(const GLuint *hits, int n)
{
    int best = -1;

    for (int i = 0; i < n; i++) {
        printf("card %u: depth %.4f to %.4f\n", hits[4 * i + 3], hits[4 * i + 1] / 4294967295.0,
               hits[4 * i + 2] / 4294967295.0);
        if (best < 0 || hits[4 * i + 1] < hits[4 * best + 1])
            best = i;
    }
    return best < 0 ? -1 : (int)hits[4 * best + 3];
}

static int pick(int x, int y)
{
    GLuint hits[4 * CARDS];
    GLint viewport[4];

    glGetIntegerv(GL_VIEWPORT, viewport);
    glSelectBuffer(4 * CARDS, hits);
    glRenderMode(GL_SELECT);
    glInitNames();
    glPushName(0);
    glMatrixMode(GL_PROJECTION);
    glPushMatrix();
    glLoadIdentity();
    gluPickMatrix(x, viewport[3] - y, 3, 3, viewport);
    set_projection();
    glMatrixMode(GL_MODELVIEW);
    draw_cards();
    glMatrixMode(GL_PROJECTION);
    glPopMatrix();
    glMatrixMode(GL_MODELVIEW);
    return nearest(hits, glRenderMode(GL_RENDER));
}

static void mouse(int button, int state, int x, int y)
{
    if (state != GLUT_DOWN)
        return;
    if (button == GLUT_RIGHT_BUTTON) {
        for (int i = 0; i < CARDS; i++)
            lifted[i] = GL_FALSE;
    } else {
        const int card = pick(x, y);
        if (card >= 0)
            lifted[card] = !lifted[card];
    }
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(400, 400);
    glutCreateWindow("pickdepth");
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glEnable(GL_DEPTH_TEST);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutMouseFunc(mouse);
    glutMainLoop();
    return 0;
}
