/*
 * rendertotexture: a picture drawn into a texture, and the texture on the faces of a cube.
 *
 * A framebuffer object puts a texture in the place of the window's colours, and a renderbuffer in that of its depths. A lit torus is
 * drawn into them; then the window is bound again and the texture is like any other. Its mipmaps are made on demand.
 *
 *   t            turn the torus
 *   m            with or without mipmaps
 *   b            show the texture itself, copied into the window with glBlitFramebuffer
 *   left right   turn the cube
 *
 * GL_ARB_framebuffer_object.
 */
#define GL_GLEXT_PROTOTYPES 1
#include <GL/glut.h>

enum { SIZE = 128 };

static GLuint framebuffer, texture;
static float torus_angle = 25, cube_angle = 35;
static int mipmaps = 1, plain_copy, window_width, window_height;

static void make_texture(void)
{
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, SIZE, SIZE, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    glGenerateMipmap(GL_TEXTURE_2D); /* room for the smaller levels */
}

static void make_framebuffer(void)
{
    GLuint depth;
    glGenRenderbuffers(1, &depth);
    glBindRenderbuffer(GL_RENDERBUFFER, depth);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, SIZE, SIZE);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

static void set_camera(double aspect, double distance)
{
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(40, aspect, 1, 20);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(0, distance * 0.4, distance, 0, 0, 0, 0, 1, 0);
}

/* The picture of the torus into the texture. */
static void draw_texture(void)
{
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, SIZE, SIZE);
    glClearColor(0.92f, 0.88f, 0.75f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    set_camera(1, 4);
    glRotatef(torus_angle, 1, 1, 0);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (float[]){0.15f, 0.45f, 0.60f, 1});
    glMaterialfv(GL_FRONT, GL_SPECULAR, (float[]){0.7f, 0.7f, 0.7f, 1});
    glMaterialf(GL_FRONT, GL_SHININESS, 40);
    glutSolidTorus(0.35, 0.85, 20, 40);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    if (mipmaps)
        glGenerateMipmap(GL_TEXTURE_2D);
}

/* A face of the cube, towards +z. */
static void face(void)
{
    glBegin(GL_QUADS);
    glNormal3f(0, 0, 1);
    glTexCoord2f(0, 0);
    glVertex3f(-1, -1, 1);
    glTexCoord2f(1, 0);
    glVertex3f(1, -1, 1);
    glTexCoord2f(1, 1);
    glVertex3f(1, 1, 1);
    glTexCoord2f(0, 1);
    glVertex3f(-1, 1, 1);
    glEnd();
}

static void draw_cube(void)
{
    set_camera((double)window_width / window_height, 6);
    glRotatef(cube_angle, 0, 1, 0);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (float[]){1, 1, 1, 1});
    glMaterialfv(GL_FRONT, GL_SPECULAR, (float[]){0, 0, 0, 1});
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, mipmaps ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
    glEnable(GL_TEXTURE_2D);
    for (int i = 0; i < 4; i++) {
        face();
        glRotatef(90, 0, 1, 0);
    }
    glRotatef(-90, 1, 0, 0);
    face();
    glDisable(GL_TEXTURE_2D);
}

static void show_copy(void)
{
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glBlitFramebuffer(0, 0, SIZE, SIZE, 8, 8, 8 + SIZE, 8 + SIZE, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
}

static void display(void)
{
    draw_texture();
    glViewport(0, 0, window_width, window_height);
    glClearColor(0.10f, 0.12f, 0.16f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw_cube();
    if (plain_copy)
        show_copy();
    glutSwapBuffers();
}

static void reshape(int width, int height)
{
    window_width = width;
    window_height = height;
}

static void key(unsigned char c, int x, int y)
{
    (void)x;
    (void)y;
    switch (c) {
    case 't': torus_angle += 20; break;
    case 'm': mipmaps = !mipmaps; break;
    case 'b': plain_copy = !plain_copy; break;
    default: return;
    }
    glutPostRedisplay();
}

static void special(int c, int x, int y)
{
    (void)x;
    (void)y;
    cube_angle += c == GLUT_KEY_RIGHT ? 5.0f : c == GLUT_KEY_LEFT ? -5.0f : 0.0f;
    glutPostRedisplay();
}

int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGBA | GLUT_DEPTH);
    glutInitWindowSize(400, 300);
    glutCreateWindow("rendertotexture");
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightfv(GL_LIGHT0, GL_POSITION, (float[]){1, 2, 3, 0});
    make_texture();
    make_framebuffer();
    glutDisplayFunc(display);
    glutReshapeFunc(reshape);
    glutKeyboardFunc(key);
    glutSpecialFunc(special);
    glutMainLoop();
    return 0;
}
