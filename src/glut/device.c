/* What GLUT has for hardware that is not there: overlays, color maps, video resizing, key repeat; and game
 * mode, which opens an ordinary window. */
#include <stdio.h>
#include <GL/glut.h>
#include "internal.h"

void glutEstablishOverlay(void)
{
    fgl_glut_require_window("glutEstablishOverlay");
}

void glutRemoveOverlay(void)
{
    fgl_glut_require_window("glutRemoveOverlay");
}

void glutUseLayer(GLenum layer)
{
    (void)layer, fgl_glut_require_window("glutUseLayer");
}

void glutPostOverlayRedisplay(void)
{
    fgl_glut_require_window("glutPostOverlayRedisplay");
}

void glutPostWindowOverlayRedisplay(int id)
{
    (void)id, fgl_glut_require_init("glutPostWindowOverlayRedisplay");
}

void glutShowOverlay(void)
{
    fgl_glut_require_window("glutShowOverlay");
}

void glutHideOverlay(void)
{
    fgl_glut_require_window("glutHideOverlay");
}

int glutVideoResizeGet(GLenum query)
{
    return query == GLUT_VIDEO_RESIZE_POSSIBLE ? 0 : -1;
}
void glutSetupVideoResizing(void) {}
void glutStopVideoResizing(void) {}
void glutVideoResize(int x, int y, int width, int height)
{
    (void)x, (void)y, (void)width, (void)height;
}

void glutVideoPan(int x, int y, int width, int height)
{
    (void)x, (void)y, (void)width, (void)height;
}

void glutIgnoreKeyRepeat(int ignore)
{
    fgl_glut_require_window("glutIgnoreKeyRepeat");
    fgl_glut.ignore_key_repeat = ignore != 0;
}

void glutSetKeyRepeat(int mode)
{
    fgl_glut_require_init("glutSetKeyRepeat");
    if (mode >= GLUT_KEY_REPEAT_OFF && mode <= GLUT_KEY_REPEAT_DEFAULT)
        fgl_glut.key_repeat = mode;
    else
        fgl_glut_warn("glutSetKeyRepeat: no mode %d", mode);
}

static struct {
    int width, height; /* asked for by glutGameModeString, 0 if not */
    int window;        /* id, 0 when game mode is not active */
} game;

void glutGameModeString(const char *mode)
{
    fgl_glut_require_init("glutGameModeString");
    int width, height;
    if (sscanf(mode, "%5dx%5d", &width, &height) == 2 && width > 0 && height > 0) {
        game.width = width;
        game.height = height;
    }
}

int glutEnterGameMode(void)
{
    fgl_glut_require_init("glutEnterGameMode");
    if (game.width)
        glutInitWindowSize(game.width, game.height);
    if (!fgl_window_find(game.window))
        game.window = glutCreateWindow("");
    return game.window;
}

void glutLeaveGameMode(void)
{
    fgl_glut_require_init("glutLeaveGameMode");
    if (fgl_window_find(game.window))
        glutDestroyWindow(game.window);
    game.window = 0;
}

int glutGameModeGet(GLenum query)
{
    fgl_glut_require_init("glutGameModeGet");
    switch (query) {
    case GLUT_GAME_MODE_ACTIVE: return fgl_window_find(game.window) != NULL;
    case GLUT_GAME_MODE_POSSIBLE: return 1;
    case GLUT_GAME_MODE_WIDTH: return game.width ? game.width : glutGet(GLUT_SCREEN_WIDTH);
    case GLUT_GAME_MODE_HEIGHT: return game.height ? game.height : glutGet(GLUT_SCREEN_HEIGHT);
    case GLUT_GAME_MODE_PIXEL_DEPTH: return 32;
    case GLUT_GAME_MODE_REFRESH_RATE: return 60;
    case GLUT_GAME_MODE_DISPLAY_CHANGED: return 0;
    default: fgl_glut_warn("glutGameModeGet: no query 0x%x", query); return -1;
    }
}
