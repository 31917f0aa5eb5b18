/* Buffer objects in scripts. */
#include "fair_buffers.h"

#include <GL/gl.h>
#include <GL/glext.h>

static int index_of(double target)
{
    return target == GL_ARRAY_BUFFER ? 0 : target == GL_ELEMENT_ARRAY_BUFFER ? 1 : target == GL_PIXEL_UNPACK_BUFFER ? 2 : 3;
}

static bool ready(const struct fair_buffers *b, int target)
{
    return b->bound[target] > 0 && b->bound[target] < FAIR_BUFFERS && b->filled[b->bound[target]];
}

/* The target into which the command's pointer is an offset; -1: none; *client: else client memory. */
static int target_of(int command, bool *client)
{
    *client = false;
    switch (command) {
    case CMD_VertexPointer: case CMD_NormalPointer: case CMD_ColorPointer: case CMD_TexCoordPointer: case CMD_EdgeFlagPointer:
    case CMD_InterleavedArrays: case CMD_SecondaryColorPointer: case CMD_FogCoordPointer: *client = true; return 0;
    case CMD_DrawElements: case CMD_DrawRangeElements: case CMD_MultiDrawElements: *client = true; return 1;
    case CMD_DrawPixels: case CMD_Bitmap: case CMD_PolygonStipple: case CMD_TexImage1D: case CMD_TexImage2D: case CMD_TexImage3D:
    case CMD_TexSubImage1D: case CMD_TexSubImage2D: case CMD_TexSubImage3D: *client = true; return 2;
    case CMD_ReadPixels: case CMD_GetTexImage: *client = true; return 3;
    case CMD_VertexPointerOffset: case CMD_NormalPointerOffset: case CMD_ColorPointerOffset: case CMD_TexCoordPointerOffset:
    case CMD_BufferSubData: case CMD_WriteMapped: return 0;
    case CMD_DrawElementsOffset: case CMD_DrawRangeElementsOffset: case CMD_MultiDrawElementsOffset: return 1;
    case CMD_DrawPixelsOffset: case CMD_BitmapOffset: case CMD_PolygonStippleOffset: case CMD_TexImage2DOffset: case CMD_TexSubImage2DOffset: return 2;
    case CMD_ReadPixelsOffset: return 3;
    default: return -1;
    }
}

bool fair_buffers_follow(struct fair_buffers *b, const struct script *s, int i)
{
    const int command = s->op[i].command;
    const double *v = s->value + s->op[i].first;
    bool client;
    const int target = target_of(command, &client);
    if (command == CMD_BindBuffer)
        b->bound[index_of(v[0])] = (int)v[1];
    else if (command == CMD_DeleteBuffers && v[1] < FAIR_BUFFERS)
        b->filled[(int)v[1]] = false;
    else if ((command == CMD_BufferData || command == CMD_BufferSize) && b->bound[index_of(v[0])] < FAIR_BUFFERS)
        b->filled[b->bound[index_of(v[0])]] = true;
    else if (target >= 0)
        return client ? b->bound[target] == 0 : ready(b, target);
    return true;
}
