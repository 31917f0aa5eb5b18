/*
 * unproject: from a pixel back to the world.
 *
 * A pixel is a ray: gluUnProject turns it into the point on the near plane (window z 0) and the one on the
 * far plane (window z 1). Where the ray between them meets the floor, a pin is put, and the coordinates are
 * printed.
 *
 *   left button    put a pin on the floor under the mouse
 *   right button   take the last pin away
 *
 * GL 1.5, 2.11.1 "Controlling the Viewport" and 2.11.2 "Matrices", both run backwards.
 */
#include <GL/glut.h>
#include <stdio.h>

enum { MAX_PINS = 32 };

static float pins[MAX_PINS][2] = {{0, 0}, {-1.3f, -1.7f}, {1.8f, -0.6f}}; /* x and z on the floor, y = 0 */
static int pin_count = 3;

static void draw_floor(void)
{
    glNormal3f(0, 1, 0);
    glBegin(GL_QUADS);
    for (int i = 0; i < 64; i++) {
        const float x = (float)(i % 8) - 4, z = (float)(i / 8) - 4;
        const float shade = (i + i / 8) % 2 ? 0.30f : 0.62f;
        glColor3f(shade, shade, 1.1f * shade);
        glVertex3f(x, 0, z);
        glVertex3f(x, 0, z + 1);
        glVertex3f(x + 1, 0, z + 1);
        glVertex3f(x + 1, 0, z);
    }
    glEnd();
}

static void draw_pin(const float place[2])
{
    glPushMatrix();
    glTranslatef(place[0], 0.7f, place[1]);
    glColor3f(0.85f, 0.20f, 0.15f);
    glutSolidSphere(0.2, 32, 24);
    glRotatef(90, 1, 0, 0); /* the cone points down */
    glColor3f(0.80f, 0.80f, 0.82f);
    glutSolidCone(0.09, 0.7, 24, 4);
    glPopMatrix();
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw_floor();
    for (int i = 0; i < pin_count; i++)
        draw_pin(pins[i]);
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(39, (double)width / height, 1, 40);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(2.5, 6.5, 12.5, -0.2, 0, 0.3, 0, 1, 0);
}

/* Where the ray through a pixel meets the floor; false if it misses. */
static GLboolean pick_floor(double window_x, double window_y, float place[2])
{
    double modelview[16], projection[16], near[3], far[3];
    GLint viewport[4];

    glGetDoublev(GL_MODELVIEW_MATRIX, modelview);
    glGetDoublev(GL_PROJECTION_MATRIX, projection);
    glGetIntegerv(GL_VIEWPORT, viewport);
    gluUnProject(window_x, window_y, 0, modelview, projection, viewport, &near[0], &near[1], &near[2]);
    gluUnProject(window_x, window_y, 1, modelview, projection, viewport, &far[0], &far[1], &far[2]);
    if (near[1] <= 0 || far[1] >= 0)
        return GL_FALSE;
    const double t = near[1] / (near[1] - far[1]);
    place[0] = (float)(near[0] + t * (far[0] - near[0]));
    place[1] = (float)(near[2] + t * (far[2] - near[2]));
    return place[0] >= -4 && place[0] <= 4 && place[1] >= -4 && place[1] <= 4;
}

static void mouse(int button, int state, int x, int y)
{
    if (state != GLUT_DOWN)
        return;
    if (button == GLUT_RIGHT_BUTTON && pin_count > 0)
        pin_count--;
    if (button == GLUT_LEFT_BUTTON && pin_count < MAX_PINS) {
        float *place = pins[pin_count];
        const double window_x = x + 0.5,
                     window_y = glutGet(GLUT_WINDOW_HEIGHT) - y - 0.5; /* y up, pixel centers */
        if (pick_floor(window_x, window_y, place)) {
            printf("pixel %d %d is the floor at %.3f %.3f\n", x, y, (double)place[0], (double)place[1]);
            pin_count++;
        }
    }
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(500, 500);
    glutCreateWindow("unproject");
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glLightfv(GL_LIGHT0, GL_POSITION, (float[]){-1, 2, 1.5f, 0});
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_COLOR_MATERIAL);
    glEnable(GL_DEPTH_TEST);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutMouseFunc(mouse);
    glutMainLoop();
    return 0;
}
