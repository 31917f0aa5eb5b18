/* FGL_EACH(f, (T, a), (U, b), ...) -> f(T, a) f(U, b) ...   FGL_LIST(f, ...): the same with commas between. */
#ifndef FGL_API_FOREACH_H
#define FGL_API_FOREACH_H

#define FGL_CAT_(a, b) a##b
#define FGL_CAT(a, b) FGL_CAT_(a, b)
#define FGL_NARGS_(_1, _2, _3, _4, _5, _6, _7, _8, _9, _10, _11, n, ...) n
#define FGL_NARGS(...) FGL_NARGS_(__VA_ARGS__, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0)

#define FGL_E1(f, p) f p
#define FGL_E2(f, p, ...) f p FGL_E1(f, __VA_ARGS__)
#define FGL_E3(f, p, ...) f p FGL_E2(f, __VA_ARGS__)
#define FGL_E4(f, p, ...) f p FGL_E3(f, __VA_ARGS__)
#define FGL_E5(f, p, ...) f p FGL_E4(f, __VA_ARGS__)
#define FGL_E6(f, p, ...) f p FGL_E5(f, __VA_ARGS__)
#define FGL_E7(f, p, ...) f p FGL_E6(f, __VA_ARGS__)
#define FGL_E8(f, p, ...) f p FGL_E7(f, __VA_ARGS__)
#define FGL_E9(f, p, ...) f p FGL_E8(f, __VA_ARGS__)
#define FGL_E10(f, p, ...) f p FGL_E9(f, __VA_ARGS__)
#define FGL_E11(f, p, ...) f p FGL_E10(f, __VA_ARGS__)
#define FGL_EACH(f, ...) FGL_CAT(FGL_E, FGL_NARGS(__VA_ARGS__))(f, __VA_ARGS__)

#define FGL_L1(f, p) f p
#define FGL_L2(f, p, ...) f p, FGL_L1(f, __VA_ARGS__)
#define FGL_L3(f, p, ...) f p, FGL_L2(f, __VA_ARGS__)
#define FGL_L4(f, p, ...) f p, FGL_L3(f, __VA_ARGS__)
#define FGL_L5(f, p, ...) f p, FGL_L4(f, __VA_ARGS__)
#define FGL_L6(f, p, ...) f p, FGL_L5(f, __VA_ARGS__)
#define FGL_L7(f, p, ...) f p, FGL_L6(f, __VA_ARGS__)
#define FGL_L8(f, p, ...) f p, FGL_L7(f, __VA_ARGS__)
#define FGL_L9(f, p, ...) f p, FGL_L8(f, __VA_ARGS__)
#define FGL_L10(f, p, ...) f p, FGL_L9(f, __VA_ARGS__)
#define FGL_L11(f, p, ...) f p, FGL_L10(f, __VA_ARGS__)
#define FGL_LIST(f, ...) FGL_CAT(FGL_L, FGL_NARGS(__VA_ARGS__))(f, __VA_ARGS__)

#define FGL_PARAM(type, name) type name
#define FGL_FIELD(type, name) type name;
#define FGL_NAME(type, name) name
#define FGL_FROM_NODE(type, name) node->name

#endif
