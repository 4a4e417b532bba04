#!/usr/bin/env python3
"""The checks of scripts/ find what they are there for, in small trees made here."""

import os
import pathlib
import platform
import shutil
import subprocess
import sys
import tempfile
import unittest

SCRIPTS = pathlib.Path(__file__).resolve().parent.parent.parent / "scripts"


def check(name: str, *arguments):
    run = subprocess.run([sys.executable, str(SCRIPTS / name), *map(str, arguments)], capture_output=True, text=True)
    return run.returncode, run.stdout + run.stderr


class FolderRule(unittest.TestCase):
    def verdict(self, files: dict):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in {"include/lustro/a.hpp": "#include <vector>\n", **files}.items():
                path = pathlib.Path(folder) / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
            return check("check_includes", folder)

    def test_leftward_includes_are_fine(self):
        code, says = self.verdict({"src/mesh/weld.cpp": '#include "mesh/weld.hpp"\n#include "math/trig.hpp"\n#include "lustro/a.hpp"\n#include <cmath>\n'})
        self.assertEqual(code, 0, says)

    def test_an_include_to_the_right_is_named_with_its_line(self):
        code, says = self.verdict({"src/mesh/weld.cpp": '#include "mesh/weld.hpp"\n\n#  include "io/obj.hpp"\n'})
        self.assertEqual(code, 1)
        self.assertIn("src/mesh/weld.cpp:3: mesh includes \"io/obj.hpp\"", says)

    def test_a_public_header_includes_public_headers_only(self):
        for line in ('#include "math/trig.hpp"', "#include <fmt/format.h>"):
            code, says = self.verdict({"include/lustro/b.hpp": line + "\n"})
            self.assertEqual(code, 1, line)
            self.assertIn("include/lustro/b.hpp:1:", says)

    def test_an_example_includes_public_headers_only(self):
        self.assertEqual(self.verdict({"examples/x.cpp": '#include "shade/lighting.hpp"\n'})[0], 1)
        self.assertEqual(self.verdict({"examples/x.cpp": "#include <lustro/lustro.hpp>\n"})[0], 0)

    def test_unknown_folders_and_unnamed_headers_are_found(self):
        self.assertEqual(self.verdict({"src/misc/x.cpp": ""})[0], 1)
        self.assertEqual(self.verdict({"src/mesh/x.cpp": '#include "x.hpp"\n'})[0], 1)
        self.assertEqual(self.verdict({"src/mesh/x.cpp": '#include "../io/x.hpp"\n'})[0], 1)

    def test_threads_stay_in_parallel_and_streams_in_app(self):
        self.assertEqual(self.verdict({"src/mesh/x.cpp": "#include <tbb/parallel_for.h>\n"})[0], 1)
        self.assertEqual(self.verdict({"src/mesh/x.cpp": "#include <thread>\n"})[0], 1)
        self.assertEqual(self.verdict({"src/io/x.cpp": "#include <iostream>\n"})[0], 1)
        self.assertEqual(self.verdict({"src/parallel/x.cpp": "#include <thread>\n"})[0], 0)

    def test_an_empty_tree_is_no_success(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(check("check_includes", folder)[0], 2)


class ImagePath(unittest.TestCase):
    def verdict(self, source: str, *flags, name="src/math/x.cpp", compiler=os.environ.get("CXX", "c++")):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "CMakeFiles" / "lustro_core.dir" / f"{name}.o"
            path.parent.mkdir(parents=True)
            subprocess.run([compiler, "-O2", "-x", "c++", "-", "-c", *flags, "-o", str(path)], input=source, text=True, check=True)
            return check("check_image_path", folder)

    def test_plain_arithmetic_is_fine(self):
        code, says = self.verdict("#include <cmath>\nfloat f(float a) { return std::sqrt(a) * a + std::floor(a); }\n", "-ffp-contract=off", "-fno-math-errno")
        self.assertEqual(code, 0, says)

    def test_libm_is_found(self):
        for call in ("sin", "pow", "expf", "atan2"):
            arguments = "a, a" if call in ("pow", "atan2") else "a"
            code, says = self.verdict(f"#include <math.h>\nfloat f(float a) {{ return (float){call}({arguments}); }}\n")
            self.assertEqual(code, 1, call)
            self.assertIn(f"src/math/x.cpp: calls {call}", says)

    def test_libm_is_found_where_objects_reach_a_picture_and_only_there(self):
        source = "#include <math.h>\ndouble f(double a) { return cos(a); }\n"
        self.assertEqual(self.verdict(source, name="src/io/x.cpp")[0], 1)
        self.assertEqual(self.verdict(source, name="src/image/compare.cpp")[0], 2)  # nothing left to look at is no success

    @unittest.skipUnless(platform.machine() == "x86_64", "x86 flags")
    def test_fused_multiply_add_is_found_in_templates_too(self):
        source = "template <class F> __attribute__((noinline)) F g(F a, F b, F c) { return a * b + c; }\nfloat f(float a) { return g(a, a, a); }\n"
        code, says = self.verdict(source, "-mfma", "-ffp-contract=fast")
        self.assertEqual(code, 1, says)
        self.assertIn("g<float>", says)

    @unittest.skipUnless(platform.machine() == "x86_64", "x86 flags")
    def test_estimates_are_found(self):
        source = "#include <xmmintrin.h>\n__m128 f(__m128 a) { return _mm_rsqrt_ps(a); }\n"
        code, says = self.verdict(source)
        self.assertEqual(code, 1, says)
        self.assertIn("rsqrtps", says)

    @unittest.skipUnless(shutil.which("aarch64-linux-gnu-g++"), "no cross compiler for ARM")
    def test_arm_is_read_by_its_own_tools(self):
        fused = "float f(float a) { return a * a + a; }\nfloat g(const float* p, float a) { for (int i = 0; i < 64; ++i) { a += p[i]; } return a; }\n"
        estimate = "#include <arm_neon.h>\nfloat32x4_t f(float32x4_t a) { return vrsqrteq_f32(a); }\n"
        for source, flags, verdict in ((fused, "-ffp-contract=off", 0), (fused, "-ffp-contract=fast", 1), (estimate, "-ffp-contract=off", 1)):
            code, says = self.verdict(source, flags, compiler="aarch64-linux-gnu-g++")
            self.assertEqual(code, verdict, says)

    @unittest.skipUnless(shutil.which("em++") and shutil.which("llvm-objdump-14"), "no Emscripten")
    def test_webassembly_is_read_by_its_own_tools(self):
        for source, verdict in (("float f(float a) { return __builtin_sqrtf(a); }\n", 0), ("#include <math.h>\nfloat f(float a) { return sinf(a); }\n", 1)):
            code, says = self.verdict(source, "-fno-math-errno", compiler="em++")
            self.assertEqual(code, verdict, says)


if __name__ == "__main__":
    unittest.main()
