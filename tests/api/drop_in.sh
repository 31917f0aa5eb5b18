#!/bin/sh
# A program linked with Mesa's libOSMesa and the system's GLU draws through FixedGL under the old names.
set -eu
mesa=$(find /usr/lib /lib -name libOSMesa.so.8 2>/dev/null | head -n 1)
[ -n "$mesa" ] || { echo "skipped: no libOSMesa.so.8 to link with"; exit 0; }
case "$BUILD" in *asan*) echo "skipped: the sanitizer must be loaded first"; exit 0 ;; esac
dir=$BUILD/tests/drop_in
mkdir -p "$dir"
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
