# FixedGL. `make help` lists the targets; everything is built out of tree, in $(BUILD).
#
#   make diff    installs what is missing, builds, draws every example with FixedGL and with Mesa OSMesa, compares
#   make test    installs what is missing, builds with GCC and with Clang, runs every test

CC = gcc
BUILD = build
PREFIX = /usr/local
DESTDIR =
LIBDIR = $(PREFIX)/lib
OPT = -O3
SANITIZE =
JOBS = $(shell getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)
VERSION = 0.1.0

WARN = -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion -Wdouble-promotion -Wstrict-prototypes \
       -Wmissing-prototypes -Werror
# The picture must not depend on the compiler: no contraction to fma but where the code says so, no fast-math.
NUMERIC = -ffp-contract=off -fno-math-errno -fno-trapping-math
# Line numbers only: whole debug information costs a third of the time that kernels take to compile.
DEBUG = -g1
CFLAGS = -std=c11 $(DEBUG) $(OPT) $(NUMERIC) $(WARN) -fPIC -fvisibility=hidden -MMD -MP $(SANITIZE)
CPPFLAGS = -Iinclude -Isrc $(if $(filter base,$(ISAS)),-DFGL_ONE_ISA)
# V=1 prints whole commands.
Q = $(if $(V),,@echo '  $@';)
POSIX = -D_POSIX_C_SOURCE=200809L

# ---- libfixedgl ----

CORE_LAYERS = base state framebuffer texture vertex raster fragment pipeline api osmesa
KERNEL_SOURCES = $(wildcard $(addsuffix /kernels.c,$(addprefix src/,$(CORE_LAYERS))))
CORE_SOURCES = $(filter-out $(KERNEL_SOURCES),$(wildcard $(addsuffix /*.c,$(addprefix src/,$(CORE_LAYERS)))))

# Kernels are compiled once for each instruction set, of which src/base/cpu.c chooses at run time, and for each
# arithmetic (src/base/arith.h), of which the plan does. ISAS=base: one set, what every CPU of the architecture has.
ISAS := $(if $(filter x86_64 amd64,$(shell $(CC) -dumpmachine 2>/dev/null | cut -d- -f1)),sse2 avx2 avx512,base)
FLAGS_base =
FLAGS_sse2 =
# Tuned for processors whose gathers are fast: GCC makes none of them otherwise, and textures take half as long again.
FLAGS_avx2 = -mavx2 -mfma -mtune=skylake
FLAGS_avx512 = -mavx2 -mfma -mavx512f -mavx512vl -mavx512dq -mavx512bw -mprefer-vector-width=512 -mtune=icelake-server

ARITHS = compatible exact
DEFINE_compatible = -DFGL_ARITH_COMPATIBLE
DEFINE_exact = -DFGL_ARITH_EXACT

CORE_OBJECTS = $(CORE_SOURCES:%.c=$(BUILD)/%.o) \
               $(foreach isa,$(ISAS),$(foreach arith,$(ARITHS),$(KERNEL_SOURCES:%.c=$(BUILD)/%.$(isa).$(arith).o)))
GLUT_OBJECTS = $(patsubst %.c,$(BUILD)/%.o,$(wildcard src/glut/*.c))
CLI_OBJECTS = $(patsubst %.c,$(BUILD)/%.o,$(wildcard src/cli/*.c))
ORACLE_OBJECTS = $(patsubst %.c,$(BUILD)/%.o,$(filter-out src/oracle/main.c,$(wildcard src/oracle/*.c)))

LIB = $(BUILD)/lib
LIBS = $(LIB)/libfixedgl.a $(LIB)/libfixedgl.so $(LIB)/libfixedglut.a $(LIB)/libfixedglut.so $(DROP_IN)
# The libraries under the names that programs were linked with, in a folder of its own: LD_LIBRARY_PATH=build/lib/drop-in.
DROP_IN_GL = libGL.so libOpenGL.so.0 libOpenGL.so libOSMesa.so.8 libOSMesa.so
DROP_IN_GLUT = libglut.so libglut.so.3 libglut.so.3.12
DROP_IN = $(addprefix $(LIB)/drop-in/,libGL.so.1 $(DROP_IN_GL) $(DROP_IN_GLUT))
EXAMPLES = $(patsubst examples/%.c,$(BUILD)/examples/%,$(wildcard examples/*.c))
FIXEDGL = $(BUILD)/bin/fixedgl
MEASURE = $(BUILD)/bin/fixedgl-measure
RPATH = -Wl,-rpath,'$$ORIGIN/../lib'
RPATH_LIB = -Wl,-rpath,'$$ORIGIN:$$ORIGIN/..'

.PHONY: all libs help deps diff test check asan bench tradeoff goldens vec-report identity fuzz-diff piglit packages install clean format \
        test-programs diff-run

all: $(LIBS) $(FIXEDGL) $(MEASURE) $(EXAMPLES)
libs: $(LIBS)

help:
	@sed -n '3,4p' Makefile; echo '#   make asan | bench | tradeoff | goldens | vec-report | identity | fuzz-diff | piglit | packages | install | clean | format'

$(BUILD)/src/%.o: src/%.c
	@mkdir -p $(@D)
	$(Q)$(CC) $(CPPFLAGS) $(if $(filter src/glut/% src/cli/% src/oracle/%,$<),$(POSIX)) $(CFLAGS) -c $< -o $@

define kernel_rule
$(BUILD)/src/%.$(1).$(2).o: src/%.c
	@mkdir -p $$(@D)
	$$(Q)$$(CC) $$(CPPFLAGS) $$(CFLAGS) -DFGL_ISA=$(1) $$(FLAGS_$(1)) -DFGL_ARITH=$(2) $$(DEFINE_$(2)) -c $$< -o $$@
endef
$(foreach isa,$(ISAS),$(foreach arith,$(ARITHS),$(eval $(call kernel_rule,$(isa),$(arith)))))

# -Bsymbolic: beside a system libGL, our calls to our own functions stay ours.
$(LIB)/libfixedgl.so: $(CORE_OBJECTS)
	@mkdir -p $(@D)
	$(Q)$(CC) -shared $(SANITIZE) -Wl,-soname,libfixedgl.so.0 -Wl,-Bsymbolic $^ -lm -lpthread -o $@
	@ln -sf libfixedgl.so $(LIB)/libfixedgl.so.0

# One file under many names, and so loaded once: FixedGL, and the names that it lacks.
$(LIB)/drop-in/libGL.so.1: $(BUILD)/src/dropin/absent.o $(LIB)/libfixedgl.so
	@mkdir -p $(@D)
	$(Q)$(CC) -shared $(SANITIZE) $(RPATH_LIB) $< -L$(LIB) -lfixedgl -o $@
$(addprefix $(LIB)/drop-in/,$(DROP_IN_GL)): $(LIB)/drop-in/libGL.so.1
	@ln -sf libGL.so.1 $@
$(addprefix $(LIB)/drop-in/,$(DROP_IN_GLUT)): $(LIB)/libfixedglut.so
	@mkdir -p $(@D)
	@ln -sf ../libfixedglut.so $@

$(LIB)/libfixedglut.so: $(GLUT_OBJECTS) $(LIB)/libfixedgl.so
	$(Q)$(CC) -shared $(SANITIZE) -Wl,-soname,libfixedglut.so.0 $(RPATH_LIB) $(GLUT_OBJECTS) -L$(LIB) -lfixedgl -lpng -ldl -lm -o $@
	@ln -sf libfixedglut.so $(LIB)/libfixedglut.so.0

$(LIB)/libfixedgl.a: $(CORE_OBJECTS)
$(LIB)/libfixedglut.a: $(GLUT_OBJECTS)
%.a:
	@mkdir -p $(@D)
	@rm -f $@
	$(Q)$(AR) rcs $@ $^

# Opens both libraries at run time: linked with neither, so that neither takes the other's calls.
$(FIXEDGL): $(CLI_OBJECTS)
	@mkdir -p $(@D)
	$(Q)$(CC) $(SANITIZE) $(CLI_OBJECTS) -lpng -ldl -lm -pthread -o $@

# Measures the library that it finds: FixedGL, or OSMesa where that is preloaded.
$(MEASURE): $(ORACLE_OBJECTS) $(BUILD)/src/oracle/main.o $(LIB)/libfixedgl.so
	@mkdir -p $(@D)
	$(Q)$(CC) $(SANITIZE) $(ORACLE_OBJECTS) $(BUILD)/src/oracle/main.o -L$(LIB) -lfixedgl -lm $(RPATH) -o $@

$(BUILD)/examples/%: examples/%.c $(LIB)/libfixedglut.so $(LIB)/libfixedgl.so
	@mkdir -p $(@D)
	$(Q)$(CC) -Iinclude -std=c11 -O2 $(WARN) $(SANITIZE) -MMD -MP $< -L$(LIB) -lfixedglut -lfixedgl -lGLU -lm $(RPATH) -o $@

# ---- tests ----
# tests/unit: against internals, linked with the static library. tests/api, glut, cli: through public headers.

UNIT_TESTS = $(patsubst tests/%.c,$(BUILD)/tests/%,$(wildcard tests/unit/*.c))
API_TESTS = $(patsubst tests/%.c,$(BUILD)/tests/%,$(wildcard tests/api/*.c))
ORACLE_TESTS = $(patsubst tests/%.c,$(BUILD)/tests/%,$(wildcard tests/oracle/*.c))
SCENE_TESTS = $(if $(wildcard tests/scenes/*.c),$(BUILD)/tests/scenes/scenes)
FUZZ_FLAGS = --seed 1 --count 2000
FUZZ = $(if $(wildcard tests/fuzz/fuzz_diff.c),$(BUILD)/tests/fuzz/fuzz_diff)
GLUT_TESTS = $(patsubst tests/%.c,$(BUILD)/tests/%,$(wildcard tests/glut/*.c))
CLI_TESTS = $(patsubst tests/%.c,$(BUILD)/tests/%,$(wildcard tests/cli/*.c))
MISUSE = $(BUILD)/tests/misuse/misuse
TEST_OPT = -O2
$(BUILD)/tests/unit/light_work: TEST_OPT = -O0 # has all vertex kernels in it, and counts what they do
TEST_PROGRAMS = $(UNIT_TESTS) $(API_TESTS) $(ORACLE_TESTS) $(SCENE_TESTS) $(GLUT_TESTS) $(CLI_TESTS) $(MISUSE)
TEST_CFLAGS = -std=c11 $(DEBUG) $(TEST_OPT) $(NUMERIC) $(WARN) $(SANITIZE) $(POSIX) -D_DEFAULT_SOURCE -DGL_GLEXT_PROTOTYPES -MMD -MP \
              -Iinclude -Isrc -Itests

$(UNIT_TESTS): $(BUILD)/tests/%: tests/%.c $(LIB)/libfixedgl.a
	@mkdir -p $(@D)
	$(Q)$(CC) $(TEST_CFLAGS) $< $(LIB)/libfixedgl.a -lcmocka -ldl -lm -lpthread -o $@
$(API_TESTS): $(BUILD)/tests/%: tests/%.c $(LIB)/libfixedgl.so
	@mkdir -p $(@D)
	$(Q)$(CC) $(TEST_CFLAGS) $< -L$(LIB) -lfixedgl -Wl,-rpath,'$$ORIGIN/../../lib' -lcmocka -ldl -lm -lpthread -o $@
$(ORACLE_TESTS): $(BUILD)/tests/%: tests/%.c $(ORACLE_OBJECTS) $(LIB)/libfixedgl.so
	@mkdir -p $(@D)
	$(Q)$(CC) $(TEST_CFLAGS) $< $(ORACLE_OBJECTS) -L$(LIB) -lfixedgl -Wl,-rpath,'$$ORIGIN/../../lib' -lcmocka -ldl -lm -o $@
$(SCENE_TESTS): $(wildcard tests/scenes/*.c tests/scenes/*.h) $(LIB)/libfixedgl.so $(filter-out %/main.o,$(CLI_OBJECTS))
	@mkdir -p $(@D)
	$(Q)$(CC) $(TEST_CFLAGS) $(wildcard tests/scenes/*.c) $(filter-out %/main.o,$(CLI_OBJECTS)) -pthread -L$(LIB) -lfixedgl -Wl,-rpath,'$$ORIGIN/../../lib' -lcmocka -lpng -ldl -lm -o $@
$(FUZZ): $(wildcard tests/fuzz/*.c tests/fuzz/*.h tests/fuzz/*.def)
	@mkdir -p $(@D)
	$(Q)$(CC) $(TEST_CFLAGS) $(wildcard tests/fuzz/*.c) -ldl -lm -o $@
$(MISUSE): $(wildcard tests/misuse/*) include/GL/gl.h include/GL/glext.h $(LIB)/libfixedgl.so
	@mkdir -p $(@D)
	$(Q)$(CC) -E -P -DGL_GLEXT_PROTOTYPES -Iinclude -include GL/gl.h include/GL/glext.h | awk -f tests/misuse/calls.awk > $(@D)/calls.inc
	$(Q)$(CC) -E -dM -Iinclude -include GL/gl.h include/GL/glext.h | awk -f tests/misuse/enumerants.awk > $(@D)/enumerants.inc
	$(Q)$(CC) $(TEST_CFLAGS) -I$(@D) tests/misuse/misuse.c -L$(LIB) -lfixedgl -Wl,-rpath,'$$ORIGIN/../../lib' -lm -o $@
$(GLUT_TESTS): $(BUILD)/tests/%: tests/%.c $(LIB)/libfixedglut.a $(LIB)/libfixedgl.so
	@mkdir -p $(@D)
	$(Q)$(CC) $(TEST_CFLAGS) $< $(LIB)/libfixedglut.a -L$(LIB) -lfixedgl -Wl,-rpath,'$$ORIGIN/../../lib' -lcmocka -lpng -ldl -lm -o $@
$(CLI_TESTS): $(BUILD)/tests/%: tests/%.c $(filter-out %/main.o,$(CLI_OBJECTS))
	@mkdir -p $(@D)
	$(Q)$(CC) $(TEST_CFLAGS) $< $(filter-out %/main.o,$(CLI_OBJECTS)) -lcmocka -lpng -ldl -lm -pthread -o $@

test-programs: all $(TEST_PROGRAMS) $(FUZZ)

# One compiler's whole run: a build that prints nothing but what is wrong, then every test.
check:
	@tests/tools/step.sh "build with $(CC) in $(BUILD)" $(MAKE) -s Q=@ -j$(JOBS) test-programs
	@BUILD=$(BUILD) CC="$(CC)" JOBS=$(JOBS) tests/run $(TEST_PROGRAMS)

test: deps
	@$(MAKE) -s check CC=gcc BUILD=$(BUILD)
	@$(MAKE) -s check CC=clang BUILD=$(BUILD)/clang
	@JOBS=$(JOBS) tests/identity.sh $(BUILD) $(BUILD)/clang

# Memory is accessed alike in every instruction set: one is enough.
asan: deps
	@$(MAKE) -s check CC=gcc BUILD=$(BUILD)/asan OPT=-O1 ISAS=base \
	    SANITIZE='-fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer'

# ---- the main job ----

diff: deps
	$(MAKE) -j$(JOBS) all
	$(MAKE) diff-run
diff-run:
	$(FIXEDGL) diff --examples $(BUILD)/examples --out $(BUILD)/diff

goldens: deps
	$(MAKE) -j$(JOBS) all
	$(FIXEDGL) diff --examples $(BUILD)/examples --record tests/goldens

$(BUILD)/tests/bench/bench: $(wildcard tests/bench/*.c tests/bench/*.h)
	@mkdir -p $(@D)
	$(Q)$(CC) -std=c11 -O2 $(WARN) $(POSIX) -Iinclude $(filter %.c,$^) -ldl -lm -o $@
bench: deps
	$(MAKE) -j$(JOBS) libs $(BUILD)/tests/bench/bench
	$(BUILD)/tests/bench/bench $(LIB)/libfixedgl.so libOSMesa.so.8

tradeoff: deps
	$(MAKE) -j$(JOBS) libs $(FIXEDGL) $(MEASURE)
	$(FIXEDGL) tradeoff --out $(BUILD)/tradeoff

vec-report:
	tests/tools/vec_report.sh

fuzz-diff: deps
	$(MAKE) -j$(JOBS) libs $(FUZZ)
	$(FUZZ) $(FUZZ_FLAGS) $(LIB)/libfixedgl.so libOSMesa.so.8

# piglit's compiled tests of OpenGL 1.0 to 1.5 (docs/piglit.md); PIGLIT_ONLY='--only REGEX' runs a part.
PIGLIT_ONLY =
PIGLIT = $(BUILD)/tests/piglit
piglit: deps
	@tests/tools/deps.sh piglit libwaffle-dev python3
	$(MAKE) -j$(JOBS) libs $(PIGLIT)/libwaffle-1.so.0 $(PIGLIT)/libGL.so.1
	tests/piglit/run.py $(PIGLIT_ONLY) --expected tests/piglit/expected_failures.txt $(PIGLIT) $(LIB)/libfixedgl.so
$(PIGLIT)/libwaffle-1.so.0: tests/piglit/waffle.c
	@mkdir -p $(@D)
	$(Q)$(CC) $(CFLAGS) -I/usr/include/waffle-1 -shared $< -ldl -o $@
$(PIGLIT)/libGL.so.1: tests/piglit/glx.c
	@mkdir -p $(@D)
	$(Q)$(CC) $(CFLAGS) -shared -Wl,-soname,$(@F) $< -o $@

# Programs of other people, as Debian packages them, drawn with both (docs/porting.md).
PACKAGES = $(BUILD)/tests/packages
packages: deps
	@tests/tools/deps.sh billard-gl trend calculix-cgx libopengl-perl gle-doc libgle3-dev libghc-glut-dev libghc-glut-doc libghc-random-dev
	$(MAKE) -j$(JOBS) libs $(FIXEDGL)
	tests/packages/build.sh $(PACKAGES) $(LIB)
	LD_LIBRARY_PATH=$(abspath $(LIB)/drop-in) $(FIXEDGL) diff --pictures tests/packages/pictures.txt --departures tests/packages/departures.txt \
	    --examples $(PACKAGES) --output $(abspath $(BUILD)/packages) --reference osmesa \
	    --osmesa $$(ldconfig -p | sed -n 's/.*libOSMesa.so.8 .*=> //p' | head -n 1)

identity: deps
	$(MAKE) -j$(JOBS) all
	$(MAKE) -j$(JOBS) libs CC=clang BUILD=$(BUILD)/clang
	JOBS=$(JOBS) tests/identity.sh $(BUILD) $(BUILD)/clang

deps:
	@tests/tools/deps.sh

install: libs $(FIXEDGL) $(MEASURE)
	install -d $(addprefix $(DESTDIR)$(PREFIX)/include/,GL GLUT OpenGL) $(DESTDIR)$(LIBDIR)/pkgconfig $(DESTDIR)$(LIBDIR)/fixedgl $(DESTDIR)$(PREFIX)/bin
	install -m 644 include/fixedgl.h $(DESTDIR)$(PREFIX)/include
	for d in GL GLUT OpenGL; do install -m 644 include/$$d/*.h $(DESTDIR)$(PREFIX)/include/$$d || exit 1; done
	install -m 644 $(LIB)/libfixedgl.a $(LIB)/libfixedglut.a $(DESTDIR)$(LIBDIR)
	for l in fixedgl fixedglut; do \
	    install -m 755 $(LIB)/lib$$l.so $(DESTDIR)$(LIBDIR)/lib$$l.so.0 && \
	    ln -sf lib$$l.so.0 $(DESTDIR)$(LIBDIR)/lib$$l.so && \
	    sed -e 's|@PREFIX@|$(PREFIX)|' -e 's|@LIBDIR@|$(LIBDIR)|' -e 's|@VERSION@|$(VERSION)|' src/$$l.pc.in \
	        > $(DESTDIR)$(LIBDIR)/pkgconfig/$$l.pc || exit 1; done
	install -m 755 $(LIB)/drop-in/libGL.so.1 $(DESTDIR)$(LIBDIR)/fixedgl
	for n in $(DROP_IN_GL); do ln -sf libGL.so.1 $(DESTDIR)$(LIBDIR)/fixedgl/$$n; done
	for n in $(DROP_IN_GLUT); do ln -sf ../libfixedglut.so.0 $(DESTDIR)$(LIBDIR)/fixedgl/$$n; done
	install -m 755 $(FIXEDGL) $(MEASURE) $(DESTDIR)$(PREFIX)/bin

format:
	clang-format -i $(shell git ls-files '*.c' '*.h')

clean:
	rm -rf $(BUILD)

-include $(shell find $(BUILD) -name '*.d' 2>/dev/null)
