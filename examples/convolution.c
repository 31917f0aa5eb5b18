/*
 * convolution: what a pixel has to do with its neighbors.
 *
 * A scene is drawn, then copied onto itself three times, each time through another filter: a blur, whose weights
 * are a row times a column; edges, the difference from the neighbors; an emboss, which looks along a diagonal.
 *
 *   b        border: the edge pixels again, a constant color, or none (the image shrinks)
 *   + -      a larger or smaller blur
 *
 * GL 1.5, 3.6.3 "Convolution Filter Specification", 3.6.5 "Convolution" (GL_ARB_imaging).
 */
#define GL_GLEXT_PROTOTYPES
#include <GL/glut.h>
#include <stdio.h>
#include <stdlib.h>

enum { SIDE = 150, GAP = 10 };

static const GLenum borders[3] = {GL_REPLICATE_BORDER, GL_CONSTANT_BORDER, GL_REDUCE};
static int border, blur = 9; /* blur: pixels, odd */

static void draw_scene(void)
{
    static const GLfloat position[4] = {-1, 2, 3, 0}, red[4] = {0.8f, 0.25f, 0.2f, 1}, blue[4] = {0.25f, 0.45f, 0.8f, 1};
    glViewport(GAP, 2 * GAP + SIDE, SIDE, SIDE);
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, red);
    glPushMatrix();
    glTranslatef(-0.35f, 0.3f, 0);
    glutSolidSphere(0.55, 40, 30);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, blue);
    glTranslatef(0.75f, -0.65f, 0);
    glRotatef(30, 1, 1, 0);
    glutSolidCube(0.6);
    glPopMatrix();
    glDisable(GL_LIGHTING);
    glDisable(GL_DEPTH_TEST);
}

/* Copies the scene to the given cell; the middle of the image stays in the middle of the cell. */
static void copy_scene(int column, int row, GLenum filter, int width)
{
    const int shift = borders[border] == GL_REDUCE ? width / 2 : 0;
    const GLfloat outside[4] = {0.4f, 0.4f, 0.1f, 1};
    glConvolutionParameteri(filter, GL_CONVOLUTION_BORDER_MODE, (GLint)borders[border]);
    glConvolutionParameterfv(filter, GL_CONVOLUTION_BORDER_COLOR, outside);
    glEnable(filter);
    glWindowPos2i(GAP + column * (SIDE + GAP) + shift, GAP + row * (SIDE + GAP) + shift);
    glCopyPixels(GAP, 2 * GAP + SIDE, SIDE, SIDE, GL_COLOR);
    glDisable(filter);
}

static void blur_scene(void)
{
    GLfloat weights[31];
    for (int i = 0; i < blur; i++)
        weights[i] = 1 / (GLfloat)blur;
    glSeparableFilter2D(GL_SEPARABLE_2D, GL_LUMINANCE, blur, blur, GL_LUMINANCE, GL_FLOAT, weights, weights);
    copy_scene(1, 1, GL_SEPARABLE_2D, blur);
}

static void filter_scene(int column, const GLfloat weights[9], GLfloat bias)
{
    for (GLenum c = 0; c < 3; c++)
        glPixelTransferf(GL_POST_CONVOLUTION_RED_BIAS + c, bias);
    glConvolutionFilter2D(GL_CONVOLUTION_2D, GL_LUMINANCE, 3, 3, GL_LUMINANCE, GL_FLOAT, weights);
    copy_scene(column, 0, GL_CONVOLUTION_2D, 3);
    for (GLenum c = 0; c < 3; c++)
        glPixelTransferf(GL_POST_CONVOLUTION_RED_BIAS + c, 0);
}

static void display(void)
{
    static const GLfloat edges[9] = {-1, -1, -1, -1, 8, -1, -1, -1, -1}, emboss[9] = {2, 0, 0, 0, 0, 0, 0, 0, -2};
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw_scene();
    blur_scene();
    filter_scene(0, edges, 0);
    filter_scene(1, emboss, 0.5f);
    glutSwapBuffers();
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    border = key == 'b' ? (border + 1) % 3 : border;
    blur += 2 * ((key == '+' && blur < 31) - (key == '-' && blur > 1));
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(2 * SIDE + 3 * GAP, 2 * SIDE + 3 * GAP);
    glutCreateWindow("convolution");
    if (!glutExtensionSupported("GL_ARB_imaging")) {
        fprintf(stderr, "convolution: this OpenGL has no imaging subset\n");
        exit(1);
    }
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glMatrixMode(GL_PROJECTION);
    glOrtho(-1, 1, -1, 1, -2, 2);
    glMatrixMode(GL_MODELVIEW);
    glutDisplayFunc(display);
    glutKeyboardFunc(keyboard);
    glutMainLoop();
    return 0;
}
