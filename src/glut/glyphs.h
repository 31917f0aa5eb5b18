/* FixedGL's own line font, from which every GLUT font is made. A glyph is polylines of points on a grid: a digit
 * for x, from 0, and a letter for y, 'a' = -3 (descenders), 'd' = 0 (baseline), 'j' = 6 (small letters),
 * 'm' = 9 (capitals). A blank ends a polyline. Characters 32 to 126. */
#ifndef FGL_GLUT_GLYPHS_H
#define FGL_GLUT_GLYPHS_H

enum { GLYPH_FIRST = 32, GLYPH_LAST = 126, GLYPH_DESCENT = 3, GLYPH_CAPITAL = 9 };

/* clang-format off: tables stand in columns */
static const char *const glyphs[GLYPH_LAST - GLYPH_FIRST + 1] = {
    /* space ! " # */ "", "0m0g 0e0d", "0m0j 2m2j", "1d2m 4d5m 0g6g 0j6j",
    /* $ % & ' */ "6k5l1l0k0j1i5i6h6f5e1e0f 3m3d", "0d6m 0m2m2k0k0m 4f6f6d4d4f", "6d1j1l2m3m4l4k0g0e1d3d6g", "0m0j",
    /* ( ) * + */ "2m1l0j0g1e2d", "0m1l2j2g1e0d", "3l3f 0k6g 6k0g", "3k3e 0h6h",
    /* , - . / */ "1e1d0c", "0h5h", "0e0d", "0d6m",
    /* 0 1 2 3 */ "2d0f0k2m3m5k5f3d2d", "0k2m2d 0d4d", "0k2m4m6k6j0d6d", "0l1m5m6l6j5i2i 5i6h6e5d1d0e",
    /* 4 5 6 7 */ "5d5m0g6g", "6m0m0i4i6g6f4d1d0e", "5m2m0j0f2d4d6f6g4i2i0g", "0m6m2d",
    /* 8 9 : ; */ "2i0k0l1m5m6l6k4i2i0g0e1d5d6e6g4i", "6i4g2g0i0k2m4m6k6g4d1d", "0e0d 0j0i", "1j1i 1e1d0c",
    /* < = > ? */ "5l0h5d", "0j6j 0g6g", "0l5h0d", "0k2m4m6k6j3h3g 3e3d",
    /* @ A B C */ "4g2g2j4j4g6g6k4m2m0k0f2d5d", "0d3m6d 1g5g", "0d0m4m6l6j4i0i 4i6h6e4d0d", "6k4m2m0k0f2d4d6f",
    /* D E F G */ "0d0m4m6k6f4d0d", "6m0m0d6d 0i4i", "6m0m0d 0i4i", "6k4m2m0k0f2d4d6f6h3h",
    /* H I J K */ "0m0d 6m6d 0i6i", "0m4m 2m2d 0d4d", "5m5f3d2d0f", "0m0d 6m0g 2i6d",
    /* L M N O */ "0m0d6d", "0d0m3h6m6d", "0d0m6d6m", "2d0f0k2m4m6k6f4d2d",
    /* P Q R S */ "0d0m4m6l6i4h0h", "2d0f0k2m4m6k6f4d2d 4f6d", "0d0m4m6l6i4h0h 3h6d", "6l5m1m0l0j1i5i6h6e5d1d0e",
    /* T U V W */ "0m6m 3m3d", "0m0f2d4d6f6m", "0m3d6m", "0m1d3i5d6m",
    /* X Y Z [ */ "0m6d 0d6m", "0m3h6m 3h3d", "0m6m0d6d", "2m0m0d2d",
    /* \ ] ^ _ */ "0m6d", "0m2m2d0d", "0j3m6j", "0b6b",
    /* ` a b c */ "0m2k", "5j5d 5i4j1j0i0e1d4d5e", "0m0d 0i1j4j5i5e4d1d0e", "5i4j1j0i0e1d4d5e",
    /* d e f g */ "5m5d 5i4j1j0i0e1d4d5e", "0g5g5i4j1j0i0e1d4d5e", "4m3m2l2d 0j4j", "5j5b4a1a0b 5i4j1j0i0e1d4d5e",
    /* h i j k */ "0m0d 0i1j4j5i5d", "0j1j1d 0d2d 1m1l", "2j2b1a0a 2m2l", "0m0d 4j0g 1h4d",
    /* l m n o */ "0m1m1d 0d2d", "0d0j 0i1j2j3i3d 3i4j5j6i6d", "0d0j 0i1j4j5i5d", "1d0e0i1j4j5i5e4d1d",
    /* p q r s */ "0a0j 0i1j4j5i5e4d1d0e", "5a5j 5i4j1j0i0e1d4d5e", "0d0j 0h2j4j", "5i4j1j0i0h1g4g5f5e4d1d0e",
    /* t u v w */ "2m2e3d4d 0j4j", "0j0e1d4d5e 5j5d", "0j2d4j", "0j1d3h5d6j",
    /* x y z { */ "0j5d 0d5j", "0j3d 6j2b1a0a", "0j5j0d5d", "3m2m1l1i0h1g1e2d3d",
    /* | } ~ */ "0m0a", "0m1m2l2i3h2g2e1d0d", "0h1i2i4g5g6h"};
/* clang-format on */

#endif
