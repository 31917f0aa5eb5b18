/*
 * material: twenty spheres under the same light, each with another material.
 *
 * From left to right the color changes, from top to bottom the terms of the lighting equation join in:
 * diffuse alone, a wide highlight, a narrow highlight, and emission, which is there without any light.
 *
 *   v   viewer: infinite, or local, which moves the highlights of the outer spheres
 *   p   light: directional, or positional and near, which shades each column from another side
 *
 * GL 1.5, 2.14.1 "Lighting" (the terms) and 2.14.2 (glMaterial, GL_LIGHT_MODEL_LOCAL_VIEWER).
 */
#include <GL/glut.h>

enum { COLUMNS = 5, ROWS = 4 };

static const float colors[COLUMNS][4] = {
        {0.80f, 0.22f, 0.18f, 1}, {0.85f, 0.58f, 0.15f, 1}, {0.25f, 0.60f, 0.25f, 1},
        {0.15f, 0.45f, 0.75f, 1}, {0.50f, 0.28f, 0.65f, 1},
};

static const struct {
    float specular; /* the same for red, green and blue */
    float shininess;
    float emission; /* this much of the sphere's color */
} rows[ROWS] = {{0, 0, 0}, {0.45f, 6, 0}, {0.9f, 70, 0}, {0.9f, 70, 0.45f}};

static GLboolean local_viewer, positional;

static void draw_sphere(int row, int column)
{
    const float *color = colors[column];
    const float s = rows[row].specular, e = rows[row].emission;

    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, color);
    glMaterialfv(GL_FRONT, GL_SPECULAR, (float[]){s, s, s, 1});
    glMaterialf(GL_FRONT, GL_SHININESS, rows[row].shininess);
    glMaterialfv(GL_FRONT, GL_EMISSION, (float[]){e * color[0], e * color[1], e * color[2], 1});
    glPushMatrix();
    glTranslatef((float)column - 2, 1.5f - (float)row, 0);
    glutSolidSphere(0.43, 40, 28);
    glPopMatrix();
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, local_viewer);
    glLightfv(GL_LIGHT0, GL_POSITION, (float[]){-1, 1.5f, 2, positional ? 1 : 0});
    for (int row = 0; row < ROWS; row++)
        for (int column = 0; column < COLUMNS; column++)
            draw_sphere(row, column);
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    const double fit = width * 4 < height * 5 ? 2.6 / width : 2.1 / height; /* units per half pixel */

    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(-fit * width, fit * width, -fit * height, fit * height, 1, 10);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(0, 0, 4, 0, 0, 0, 0, 1, 0);
}

static void keyboard(unsigned char key, int x, int y)
{
    (void)x, (void)y;
    if (key == 'v')
        local_viewer = !local_viewer;
    else if (key == 'p')
        positional = !positional;
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(600, 480);
    glutCreateWindow("material");
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
