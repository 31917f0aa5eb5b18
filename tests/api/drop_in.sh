#!/bin/sh
# Programs that are already compiled draw through FixedGL under the old names: one linked with Mesa's libOSMesa and the
# system's GLU, and one of GLUT and libGL that resolves every name at the start, those that FixedGL lacks too.
set -eu
case "$BUILD" in *asan*) echo "skipped: the sanitizer must be loaded first"; exit 0 ;; esac
dir=$BUILD/tests/drop_in
mkdir -p "$dir"

# What FixedGL has must not be absent: the stub would hide it.
if nm -D --defined-only "$BUILD/lib/drop-in/libGL.so.1" "$BUILD/lib/libfixedgl.so" | sed -n 's/.* T //p' | sort | uniq -d | grep .; then
    echo "src/dropin/absent.def names functions that FixedGL has"
    exit 1
fi

# The old libraries, as far as a linker looks at them.
stub() { # stub SONAME FUNCTION...
    name=$1
    shift
    for f in "$@"; do echo "void $f(void) {}"; done | $CC -shared -fPIC -x c - -Wl,-soname,"$name" -o "$dir/$name"
}
stub libglut.so.3 glutInit glutCreateWindow glutDisplayFunc glutMainLoop
stub libGL.so.1 glClearColor glClear glGetString glCreateShader glXGetCurrentContext glXGetProcAddressARB
cat >"$dir/old.c" <<'EOF'
#include <GL/glut.h>
#include <stdio.h>
extern unsigned int glCreateShader(unsigned int type);
extern void *glXGetCurrentContext(void);
extern void (*glXGetProcAddressARB(const unsigned char *name))(void);
/* The questions that GLEW asks before it loads anything. */
static int glew_is_answered(void)
{
    int major = 0, minor = 0;
    void *(*current)(void) = (void *(*)(void))glXGetProcAddressARB((const unsigned char *)"glXGetCurrentDisplay");
    int (*version)(void *, int *, int *) = (int (*)(void *, int *, int *))glXGetProcAddressARB((const unsigned char *)"glXQueryVersion");
    const char *(*string)(void *, int) = (const char *(*)(void *, int))glXGetProcAddressARB((const unsigned char *)"glXGetClientString");
    return current && current() && version && version(current(), &major, &minor) && major == 1 && minor == 4 && string &&
           *string(current(), 3) == 0;
}
static void display(void)
{
    printf("glew %d ", glew_is_answered());
    glClearColor(0, 1, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    printf("%s %d %d %d %d\n", (const char *)glGetString(GL_RENDERER), glXGetCurrentContext() != NULL,
           glXGetProcAddressARB((const unsigned char *)"glBegin") != NULL,
           glXGetProcAddressARB((const unsigned char *)"glCreateShader") != NULL, glCreateShader(0x8b31));
}
int main(int argc, char **argv)
{
    glutInit(&argc, argv);
    glutCreateWindow("old");
    glutDisplayFunc(display);
    glutMainLoop();
    return 0;
}
EOF
$CC -Iinclude "$dir/old.c" "$dir/libglut.so.3" "$dir/libGL.so.1" -Wl,-z,now -o "$dir/old"
answer=$(LD_LIBRARY_PATH=$BUILD/lib/drop-in FIXEDGL_CAPTURE=$dir/old.pam "$dir/old" 2>"$dir/old.err")
echo "$answer"
cat "$dir/old.err"
case "$answer" in "glew 1 FixedGL"*" 1 1 0 0") ;; *) exit 1 ;; esac
grep -q "there is no glCreateShader here" "$dir/old.err"
[ -s "$dir/old.pam" ]

mesa=$(find /usr/lib /lib -name libOSMesa.so.8 2>/dev/null | head -n 1)
[ -n "$mesa" ] || { echo "skipped: no libOSMesa.so.8 to link with"; exit 0; }
cat >"$dir/program.c" <<'EOF'
#include <GL/glu.h>
#include <GL/osmesa.h>
#include <stdio.h>
#include <string.h>
int main(void)
{
    static unsigned char pixels[64 * 64 * 4];
    OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, NULL);
    if (!context || !OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, 64, 64))
        return 1;
    GLUquadric *quadric = gluNewQuadric();
    glColor3f(1, 0, 0);
    gluDisk(quadric, 0, 0.5, 16, 1); /* fails to reach our buffer if libGLU called another library */
    glFinish();
    printf("%s %d %d\n", (const char *)glGetString(GL_RENDERER), pixels[(32 * 64 + 32) * 4], glGetError());
    return 0;
}
EOF
$CC -Iinclude "$dir/program.c" "$mesa" -lGLU -o "$dir/program"
answer=$(LD_LIBRARY_PATH=$BUILD/lib/drop-in "$dir/program")
echo "$answer"
case "$answer" in *FixedGL*" 255 0") ;; *) exit 1 ;; esac
