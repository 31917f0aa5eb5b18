/*
 * texture3d: a teapot carved from marble that has a grain inside.
 *
 * A three-dimensional texture is a block of material. Coordinates are generated from object coordinates, so
 * every point of the surface shows what the block has there; a plane cuts through the block beside it.
 *
 *   left right   turn
 *   + -          move the plane
 *
 * GL 1.5, 3.8.1 "Texture Image Specification" (glTexImage3D).
 */
#include <GL/glut.h>

enum { SIZE = 32 };

static int angle = 20;
static float depth = 0.4f;

/* Rings around an axis that leans, in a whole number of steps so that every machine makes the same image. */
static void make_texture(void)
{
    static GLubyte image[SIZE][SIZE][SIZE][3];
    for (int r = 0; r < SIZE; r++)
        for (int t = 0; t < SIZE; t++)
            for (int s = 0; s < SIZE; s++) {
                const int x = 2 * s - SIZE + r / 4, y = 2 * t - SIZE, ring = (x * x + y * y) / 24 + (r * r) / 40;
                GLubyte *texel = image[r][t][s];
                const int dark = ring % 6 * 18;
                texel[0] = (GLubyte)(228 - dark);
                texel[1] = (GLubyte)(190 - dark);
                texel[2] = (GLubyte)(140 - dark / 2);
            }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGB, SIZE, SIZE, SIZE, 0, GL_RGB, GL_UNSIGNED_BYTE, image);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

static void generate_coordinates(void)
{
    static const float planes[3][4] = {{0.25f, 0, 0, 0.5f}, {0, 0.25f, 0, 0.5f}, {0, 0, 0.25f, 0.5f}};
    for (int i = 0; i < 3; i++) {
        const GLenum coordinate = GL_S + (GLenum)i;
        glTexGeni(coordinate, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
        glTexGenfv(coordinate, GL_OBJECT_PLANE, planes[i]);
        glEnable(GL_TEXTURE_GEN_S + (GLenum)i);
    }
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glPushMatrix();
    glRotatef(20, 1, 0, 0);
    glRotatef((float)angle, 0, 1, 0);
    glEnable(GL_LIGHTING);
    glPushMatrix();
    glTranslatef(0, 0.35f, 0);
    glutSolidTeapot(0.8);
    glPopMatrix();
    glDisable(GL_LIGHTING);
    glColor3f(1, 1, 1);
    glBegin(GL_QUADS);
    glVertex3f(-1.6f, -0.5f - depth, -1.6f);
    glVertex3f(-1.6f, -0.5f - depth, 1.6f);
    glVertex3f(1.6f, -0.5f - depth, 1.6f);
    glVertex3f(1.6f, -0.5f - depth, -1.6f);
    glEnd();
    glPopMatrix();
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(40, (double)width / height, 1, 20);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0, 0.2f, -4.8f);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    depth += key == '+' ? 0.1f : key == '-' ? -0.1f : 0;
    glutPostRedisplay();
}

static void special(int key, int x, int y)
{
    (void)x, (void)y;
    angle += key == GLUT_KEY_RIGHT ? 15 : key == GLUT_KEY_LEFT ? -15 : 0;
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(320, 240);
    glutCreateWindow("texture3d");
    glClearColor(0.16f, 0.18f, 0.20f, 1);
    glLightfv(GL_LIGHT0, GL_POSITION, (float[]){1, 2, 2, 0});
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (float[]){1, 1, 1, 1});
    glEnable(GL_LIGHT0);
    glEnable(GL_NORMALIZE);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_TEXTURE_3D);
    make_texture();
    generate_coordinates();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(keyboard);
    glutSpecialFunc(special);
    glutMainLoop();
    return 0;
}
