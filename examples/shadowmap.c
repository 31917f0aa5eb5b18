/*
 * shadowmap: shadows by comparing distances from the lamp.
 *
 * First the scene is drawn as the lamp sees it, and its depths become a texture. Then it is drawn for the eye:
 * coordinates generated in eye space say where every point was in the lamp's picture and how far away, and the
 * comparison with the texture says whether something nearer was there.
 *
 *   m            show the lamp's depths instead of comparing
 *   l            compare one depth, or four and mix
 *   left right   move the lamp
 *
 * GL 1.5, 3.8.14 "Texture Comparison Modes", 2.11.4 "Generating Texture Coordinates".
 */
#include <GL/glut.h>

enum { MAP = 128 };

static int compares = 1, filter = GL_NEAREST, window_width, window_height;
static float lamp_x = -2.2f;

static void draw_scene(void)
{
    glNormal3f(0, 1, 0);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (float[]){0.72f, 0.70f, 0.64f, 1});
    glBegin(GL_QUADS);
    glVertex3f(-3, 0, -3);
    glVertex3f(-3, 0, 3);
    glVertex3f(3, 0, 3);
    glVertex3f(3, 0, -3);
    glEnd();
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (float[]){0.80f, 0.35f, 0.25f, 1});
    glPushMatrix();
    glTranslatef(-0.8f, 0.7f, 0.3f);
    glutSolidSphere(0.6, 24, 16);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (float[]){0.30f, 0.50f, 0.75f, 1});
    glTranslatef(1.7f, 0, -0.4f);
    glRotatef(30, 0, 1, 0);
    glScalef(1, 1.4f, 1);
    glutSolidCube(0.9);
    glPopMatrix();
}

static void lamp_view(void)
{
    gluPerspective(60, 1, 1.5, 9);
    gluLookAt((double)lamp_x, 4, 2.2, 0, 0, 0, 0, 1, 0);
}

/* The lamp's picture into the texture. */
static void make_map(void)
{
    glViewport(0, 0, MAP, MAP);
    glMatrixMode(GL_PROJECTION);
    glPushMatrix();
    glLoadIdentity();
    lamp_view();
    glMatrixMode(GL_MODELVIEW);
    glPushMatrix();
    glLoadIdentity();
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_POLYGON_OFFSET_FILL); /* pushes surfaces out of their own shadow */
    glPolygonOffset(2, 8);
    draw_scene();
    glDisable(GL_POLYGON_OFFSET_FILL);
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, 0, 0, MAP, MAP, 0);
    glPopMatrix();
    glMatrixMode(GL_PROJECTION);
    glPopMatrix();
    glMatrixMode(GL_MODELVIEW);
    glViewport(0, 0, window_width, window_height);
}

/* From eye space back to the world (the planes are given under the eye's view), to the lamp's clip space, to [0,1]. */
static void generate_coordinates(void)
{
    static const float planes[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
    for (GLenum i = 0; i < 4; i++) {
        glTexGeni(GL_S + i, GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR);
        glTexGenfv(GL_S + i, GL_EYE_PLANE, planes[i]);
        glEnable(GL_TEXTURE_GEN_S + i);
    }
    glMatrixMode(GL_TEXTURE);
    glLoadIdentity();
    glTranslatef(0.5f, 0.5f, 0.5f);
    glScalef(0.5f, 0.5f, 0.5f);
    lamp_view();
    glMatrixMode(GL_MODELVIEW);
}

static void display(void)
{
    glLightfv(GL_LIGHT0, GL_POSITION, (float[]){lamp_x, 4, 2.2f, 1});
    make_map();
    generate_coordinates();
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, compares ? GL_COMPARE_R_TO_TEXTURE : GL_NONE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_TEXTURE_2D);
    draw_scene();
    glDisable(GL_TEXTURE_2D);
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    window_width = width;
    window_height = height;
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(40, (double)width / height, 1, 20);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(0.8, 3.4, 5.6, 0, 0.3, 0, 0, 1, 0);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 'm')
        compares = !compares;
    if (key == 'l')
        filter = filter == GL_NEAREST ? GL_LINEAR : GL_NEAREST;
    glutPostRedisplay();
}

static void special(int key, int x, int y)
{
    (void)x, (void)y;
    lamp_x += key == GLUT_KEY_RIGHT ? 0.4f : key == GLUT_KEY_LEFT ? -0.4f : 0;
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(320, 240);
    glutCreateWindow("shadowmap");
    glClearColor(0.55f, 0.62f, 0.70f, 1);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_NORMALIZE);
    glEnable(GL_DEPTH_TEST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutSpecialFunc(special);
    glutMainLoop();
    return 0;
}
