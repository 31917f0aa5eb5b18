/*
 * feedback: what GL makes of a scene, as numbers.
 *
 * The scene is drawn twice: to the window, and in feedback mode, which draws nothing and returns every
 * primitive, clipped and in window coordinates, with its color. Markers made with glPassThrough tell the
 * objects apart. The table goes to standard output.
 *
 *   p   print again
 *
 * GL 1.5, 5.3 "Feedback".
 */
#include <GL/glut.h>
#include <stdio.h>

enum { VALUES = 2048, ARROW = 1, SIGN = 2, STARS = 3 };

static GLfloat buffer[VALUES];

static void draw_arrow(void)
{
    glBegin(GL_LINES);
    glColor3f(0.95f, 0.75f, 0.3f);
    glVertex2f(-0.8f, -0.6f);
    glVertex2f(1.3f, 0.7f); /* beyond the window: comes back clipped */
    glEnd();
}

static void draw_sign(void)
{
    static const float corners[4][2] = {{-0.5f, 0}, {0, -0.55f}, {0.5f, 0}, {0, 0.55f}};

    glBegin(GL_POLYGON);
    for (int i = 0; i < 4; i++) {
        glColor3f(0.2f, 0.4f + 0.1f * (float)i, 0.9f - 0.2f * (float)i);
        glVertex2fv(corners[i]);
    }
    glEnd();
}

static void draw_stars(void)
{
    glColor3f(1, 1, 1);
    glBegin(GL_POINTS);
    glVertex3f(-0.7f, 0.7f, 0.5f);
    glVertex3f(0.6f, 0.8f, 0);
    glVertex3f(0.9f, 2.5f, 0); /* outside: does not come back */
    glEnd();
}

static void draw_scene(void)
{
    glPassThrough(SIGN);
    draw_sign();
    glPassThrough(ARROW);
    draw_arrow();
    glPassThrough(STARS);
    draw_stars();
}

static const GLfloat *print_vertices(const GLfloat *v, int n)
{
    for (int i = 0; i < n; i++, v += 7)
        printf("    (%.2f %.2f %.3f) color %.2f %.2f %.2f %.2f\n", (double)v[0], (double)v[1], (double)v[2],
               (double)v[3], (double)v[4], (double)v[5], (double)v[6]);
    return v;
}

static void print_buffer(int n)
{
    static const char *const names[] = {"", "arrow", "sign", "stars"};
    const GLfloat *v = buffer;

    printf("%d values\n", n);
    while (v < buffer + n) {
        switch ((int)*v++) {
        case GL_PASS_THROUGH_TOKEN: printf("%s\n", names[(int)*v++]); break;
        case GL_POINT_TOKEN:
            printf("  point\n");
            v = print_vertices(v, 1);
            break;
        case GL_LINE_TOKEN:
        case GL_LINE_RESET_TOKEN:
            printf("  line\n");
            v = print_vertices(v, 2);
            break;
        case GL_POLYGON_TOKEN:
            printf("  polygon\n");
            v = print_vertices(v + 1, (int)*v);
            break;
        }
    }
}

static void print_scene(void)
{
    glFeedbackBuffer(VALUES, GL_3D_COLOR, buffer);
    glRenderMode(GL_FEEDBACK);
    draw_scene();
    print_buffer(glRenderMode(GL_RENDER));
}

static void display(void)
{
    static GLboolean printed;

    glClear(GL_COLOR_BUFFER_BIT);
    glLineWidth(3);
    glPointSize(5);
    draw_scene();
    if (!printed)
        print_scene();
    printed = GL_TRUE;
    glutSwapBuffers();
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 'p')
        print_scene();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB);
    glutInitWindowSize(300, 300);
    glutCreateWindow("feedback");
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glutDisplayFunc(display);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
