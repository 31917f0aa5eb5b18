/*
 * teapots: sixteen teapots from one display list, each of another substance.
 *
 * The list of the whole grid holds matrices, materials and sixteen calls of the teapot's list. A called list
 * is looked up when the call is executed: compiling the teapot's list again, turned, turns all of them and
 * leaves the grid alone.
 *
 *   left, right   turn the teapots
 *
 * GL 1.5, 5.4 "Display Lists" and 2.14.2 "Lighting Parameter Specification" (glMaterial).
 */
#include <GL/glut.h>

enum { SIDE = 4, GRID = 1, TEAPOT = 2 }; /* teapots along a side of the grid; names of the lists */

static const struct {
    float diffuse[4], specular[4], shininess;
} substances[SIDE * SIDE] = {
        {{0.58f, 0.40f, 0.10f, 1}, {0.95f, 0.85f, 0.50f, 1}, 40},  /* gold */
        {{0.45f, 0.46f, 0.48f, 1}, {0.90f, 0.90f, 0.92f, 1}, 60},  /* silver */
        {{0.52f, 0.24f, 0.12f, 1}, {0.80f, 0.50f, 0.35f, 1}, 20},  /* copper */
        {{0.22f, 0.24f, 0.28f, 1}, {0.55f, 0.60f, 0.70f, 1}, 90},  /* steel */
        {{0.62f, 0.05f, 0.10f, 1}, {0.90f, 0.60f, 0.60f, 1}, 80},  /* ruby */
        {{0.06f, 0.50f, 0.22f, 1}, {0.60f, 0.90f, 0.70f, 1}, 80},  /* emerald */
        {{0.10f, 0.18f, 0.62f, 1}, {0.60f, 0.65f, 0.95f, 1}, 80},  /* sapphire */
        {{0.42f, 0.20f, 0.55f, 1}, {0.80f, 0.70f, 0.90f, 1}, 80},  /* amethyst */
        {{0.50f, 0.62f, 0.48f, 1}, {0.30f, 0.32f, 0.30f, 1}, 12},  /* jade */
        {{0.25f, 0.65f, 0.65f, 1}, {0.30f, 0.35f, 0.35f, 1}, 14},  /* turquoise */
        {{0.75f, 0.72f, 0.66f, 1}, {0.35f, 0.34f, 0.32f, 1}, 24},  /* marble */
        {{0.04f, 0.04f, 0.05f, 1}, {0.60f, 0.60f, 0.65f, 1}, 50},  /* obsidian */
        {{0.62f, 0.32f, 0.20f, 1}, {0.02f, 0.02f, 0.02f, 1}, 1},   /* clay */
        {{0.85f, 0.83f, 0.78f, 1}, {1.00f, 1.00f, 1.00f, 1}, 120}, /* porcelain */
        {{0.70f, 0.55f, 0.05f, 1}, {0.25f, 0.25f, 0.20f, 1}, 8},   /* yellow rubber */
        {{0.15f, 0.35f, 0.10f, 1}, {0.80f, 0.80f, 0.80f, 1}, 110}, /* green enamel */
};

static float turn; /* degrees around each teapot's own axis */

static void compile_teapot(void)
{
    glNewList(TEAPOT, GL_COMPILE);
    glRotatef(18, 1, 0, 0);
    glRotatef(turn, 0, 1, 0);
    glutSolidTeapot(0.36);
    glEndList();
}

static void compile_grid(void)
{
    glNewList(GRID, GL_COMPILE);
    for (int i = 0; i < SIDE * SIDE; i++) {
        glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, substances[i].diffuse);
        glMaterialfv(GL_FRONT, GL_SPECULAR, substances[i].specular);
        glMaterialf(GL_FRONT, GL_SHININESS, substances[i].shininess);
        glPushMatrix();
        glTranslatef(1.2f * (float)(i % SIDE) - 1.85f, 1.26f - 0.86f * (float)(i / SIDE), 0);
        glCallList(TEAPOT);
        glPopMatrix();
    }
    glEndList();
}

static void display(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glCallList(GRID);
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    const double fit = width * 3 < height * 4 ? 2.4 / width : 1.8 / height; /* units per half pixel */

    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(-fit * width, fit * width, -fit * height, fit * height, -2, 2);
    glMatrixMode(GL_MODELVIEW);
}

static void special(int key, int x, int y)
{
    (void)x, (void)y;
    if (key == GLUT_KEY_LEFT || key == GLUT_KEY_RIGHT)
        turn += key == GLUT_KEY_LEFT ? -15 : 15;
    compile_teapot();
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH);
    glutInitWindowSize(640, 480);
    glutCreateWindow("teapots");
    glClearColor(0.09f, 0.10f, 0.13f, 1);
    glLightfv(GL_LIGHT0, GL_POSITION, (float[]){-1, 2, 2, 0});
    glLightfv(GL_LIGHT0, GL_AMBIENT, (float[]){0.25f, 0.25f, 0.3f, 1});
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    compile_teapot();
    compile_grid();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutSpecialFunc(special);
    glutMainLoop();
    return 0;
}
