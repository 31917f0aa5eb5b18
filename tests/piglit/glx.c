/* A libGL.so.1 without a window system: piglit's helper library asks for these names when it is loaded. It calls only
 * glXGetProcAddress on the way that tests/piglit/waffle.c opens. */
#define API __attribute__((visibility("default")))
#define ABSENT(name)                                                                                                   \
    API void *name(void);                                                                                              \
    void *name(void)                                                                                                   \
    {                                                                                                                  \
        return 0;                                                                                                      \
    }

ABSENT(glXChooseVisual)
ABSENT(glXCreateContext)
ABSENT(glXCreateNewContext)
ABSENT(glXCreatePixmap)
ABSENT(glXDestroyContext)
ABSENT(glXGetCurrentDisplay)
ABSENT(glXGetCurrentDrawable)
ABSENT(glXGetFBConfigAttrib)
ABSENT(glXGetFBConfigs)
ABSENT(glXGetVisualFromFBConfig)
ABSENT(glXMakeCurrent)
ABSENT(glXQueryExtension)
ABSENT(glXQueryExtensionsString)
ABSENT(glXQueryVersion)

API void *waffle_get_proc_address(const char *name);
API void *glXGetProcAddress(const char *name);
API void *glXGetProcAddressARB(const char *name);

void *glXGetProcAddress(const char *name)
{
    return waffle_get_proc_address(name);
}
void *glXGetProcAddressARB(const char *name)
{
    return waffle_get_proc_address(name);
}
