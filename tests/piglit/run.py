#!/usr/bin/env python3
"""Runs piglit's compiled tests of OpenGL 1.0 to 1.5 and its fixed-function extensions on an OSMesa library.

usage: run.py [--only REGEX] [--jobs N] [--timeout SECONDS] [--expected FILE] STAND_INS LIBRARY

STAND_INS is the folder with our libwaffle-1.so.0 and libGL.so.1. Each test draws to the OSMesa buffer. Prints a line
for each test that did not pass, then the counts. FILE lists tests that are known to fail, one a line:
"name: reason". The exit status is 1 when another test fails, or one of these passes: the list may only shrink.
"""
import argparse
import concurrent.futures
import os
import re
import shlex
import subprocess
import sys

PIGLIT = '/usr/lib/x86_64-linux-gnu/piglit'
WANTED = re.compile(
    r'spec@(!opengl 1\.[0-5]|arb_depth_texture|arb_imaging|arb_multitexture|arb_point_parameters|arb_shadow'
    r'|arb_texture_border|arb_texture_cube|arb_texture_env|ext_fog_coord|ext_separate|ext_texture_env_combine'
    r'|ext_texture_lod_bias)')
LATER = re.compile(r'glsl|cube_map_array|samples=')  # needs more than OpenGL 1.5


def commands(only):
    """(name, argv) of each test of piglit's profile quick_gl that is ours."""
    listing = subprocess.run(['piglit', 'print-cmd', 'quick_gl'], capture_output=True, text=True, check=True).stdout
    for line in listing.splitlines():
        name, separator, command = line.partition(' ::: ')
        if separator and WANTED.search(name) and not LATER.search(name) and re.search(only, name):
            program, *arguments = shlex.split(command)
            path = os.path.join(PIGLIT, 'bin', os.path.basename(program))
            if os.path.exists(path):  # the others are scripts for a shader runner
                yield name, [path] + [a for a in arguments if a != '-fbo']


def result_of(argv, environment, timeout):
    try:
        test = subprocess.run(argv, env=environment, cwd=PIGLIT, timeout=timeout, capture_output=True, text=True,
                              errors='replace')
    except subprocess.TimeoutExpired:
        return 'timeout'
    results = re.findall(r'PIGLIT: \{"result": "(\w+)"', test.stdout)
    return results[-1] if results and test.returncode >= 0 else 'crash'


def run_all(tests, environment, options):
    results = {}
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        waiting = {pool.submit(result_of, argv, environment, options.timeout): name for name, argv in tests}
        for done in concurrent.futures.as_completed(waiting):
            results[waiting[done]] = done.result()
            if sys.stderr.isatty():
                print(f'\r{len(results)} of {len(tests)}', end='', file=sys.stderr)
    return results


def expected_failures(path):
    if not path:
        return {}
    with open(path, encoding='utf-8') as lines:
        return dict(line.rstrip('\n').split(': ', 1) for line in lines if line.strip() and not line.startswith('#'))


def report(results, expected, only):
    wrong = 0
    for name, result in sorted(results.items()):
        if result == 'pass' and name in expected:
            print(f'passes although it is expected to fail: {name}')
            wrong += 1
        elif result != 'pass':
            print(f'{result:8} {name}' + (f' ({expected[name]})' if name in expected else ''))
            wrong += name not in expected
    for name in expected if only == '.' else []:
        if name not in results:
            print(f'expected to fail, but no such test: {name}')
            wrong += 1
    counts = {r: list(results.values()).count(r) for r in sorted(set(results.values()))}
    print(', '.join(f'{n} {r}' for r, n in counts.items()) + f', of {len(results)} piglit tests; {wrong} not as expected')
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n')[0])
    parser.add_argument('stand_ins')
    parser.add_argument('library')
    parser.add_argument('--only', default='.')
    parser.add_argument('--jobs', type=int, default=os.cpu_count())
    parser.add_argument('--timeout', type=float, default=60)
    parser.add_argument('--expected')
    options = parser.parse_args()
    environment = dict(os.environ, PIGLIT_OSMESA=os.path.abspath(options.library) if '/' in options.library
                       else options.library, LD_LIBRARY_PATH=os.path.abspath(options.stand_ins), PIGLIT_PLATFORM='gbm')
    results = run_all(list(commands(options.only)), environment, options)
    sys.exit(1 if report(results, expected_failures(options.expected), options.only) else 0)


main()
