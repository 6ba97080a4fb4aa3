"""Shaders of one's own: what is wrong with them is told by file, line and column, and none of them hangs the kit."""

import json
import os
import struct

import kit

ENTRY = """#version 450
#include "trace_entry.glsl"

void main() {
  Ray ray;
  RayHit hit;
  if (trace_begin(ray, hit)) {
%s
  }
  trace_end(hit);
}
"""
OUTPUTS = ("layout(location = 0) out ivec2 a;\nlayout(location = 1) out vec4 b;\nlayout(location = 2) out uvec4 c;\n"
           "void main() { a = ivec2(-1); b = %s; c = uvec4(3, 0, 0, 0); }\n")


class ShaderTest(kit.KitTest):
    def trace_with(self, text, device="gl-osmesa", name="own.frag"):
        self.write(name, text)
        return self.trace("--replace", f"dda={name}", device=device)

    def assert_shader_refused(self, text, *words):
        for device in kit.DEVICES:
            with self.subTest(device):
                self.assert_refused(self.trace_with(text, device), *words)


class WhatDoesNotCompile(ShaderTest):
    def test_undeclared_name(self):
        self.assert_shader_refused(ENTRY % "    float x = nosuch;", "own.frag:8:15", "nosuch")

    def test_error_in_an_included_file_names_that_file(self):
        self.write("mine.glsl", "float f() {\n  return oops;\n}\n")
        self.assert_shader_refused('#version 450\n#include "mine.glsl"\nvoid main() {}\n', "mine.glsl:2:10", "oops")

    def test_include_that_climbs_out(self):
        self.assert_shader_refused('#version 450\n#include "../../etc/passwd"\nvoid main() {}\n', "own.frag:2", "..",
                                   "not allowed")

    def test_absolute_include(self):
        self.assert_shader_refused('#version 450\n#include "/etc/passwd"\nvoid main() {}\n', "own.frag:2", "absolute")

    def test_include_of_itself(self):
        self.assert_shader_refused('#version 450\n#include "own.frag"\nvoid main() {}\n', "own.frag:2",
                                   "includes itself")

    def test_missing_include(self):
        self.assert_shader_refused('#version 450\n#include "nosuch.glsl"\nvoid main() {}\n', "own.frag:2",
                                   "nosuch.glsl")

    def test_not_text(self):
        self.assert_shader_refused(b"\0\xff\xfe", "own.frag")

    def test_empty(self):
        self.assert_shader_refused("", "own.frag", "empty")

    def test_nested_too_deeply(self):
        text = "#version 450\nvoid main() { float x = " + "(" * 100000 + "1" + ")" * 100000 + "; }\n"
        self.assert_shader_refused(text, "own.frag:2")

    def test_compile_command_says_the_same(self):
        self.write("own.frag", ENTRY % "    float x = nosuch;")
        result = self.ssrkit("compile", "own.frag")
        self.assert_exit(2, result)
        self.assertIn("own.frag:8:15", result.out)


class WhatDriversAreGiven(ShaderTest):
    def test_modules_and_translations_are_written_and_named(self):
        result = self.ssrkit("compile", os.path.join(kit.SOURCE, "shaders", "trace_dda.frag"), "--out", "given", "--json")
        self.assert_exit(0, result)
        named = sorted(os.path.basename(file["path"]) for file in json.loads(result.out)["files"])
        self.assertEqual(sorted("trace_dda.frag." + end for end in
                                ("opengl.spv", "opengl.spvasm", "vulkan.spv", "vulkan.spvasm", "gl-glsl.glsl",
                                 "gl-softpipe.glsl")), named)
        self.assertEqual(named, sorted(os.listdir(self.path("given"))))
        for api in ("opengl", "vulkan"):
            with open(self.path("given", f"trace_dda.frag.{api}.spv"), "rb") as file:
                self.assertEqual(0x07230203, struct.unpack("<I", file.read(4))[0])
            self.assertIn("OpEntryPoint Fragment %main", self.read("given", f"trace_dda.frag.{api}.spvasm"))
        self.assertTrue(self.read("given", "trace_dda.frag.gl-glsl.glsl").startswith("#version 450"))
        self.assertTrue(self.read("given", "trace_dda.frag.gl-softpipe.glsl").startswith("#version 330"))

    def test_nothing_is_written_of_what_does_not_compile(self):
        self.write("own.frag", ENTRY % "    float x = nosuch;")
        result = self.ssrkit("compile", "own.frag", "--out", "given")
        self.assert_exit(2, result)
        self.assertEqual([], os.listdir(self.path("given")))

    def test_a_folder_that_cannot_be_is_named(self):
        self.write("file", "")
        self.write("own.frag", "#version 450\nvoid main() {}\n")
        self.assert_refused(self.ssrkit("compile", "own.frag", "--out", "file/below"), "file/below", code=3)

    def read(self, *parts):
        with open(self.path(*parts), encoding="utf-8") as file:
            return file.read()


class WhatDoesNotFit(ShaderTest):
    def test_output_of_another_kind(self):
        text = "#version 450\nlayout(location = 0) out vec4 colour;\nvoid main() { colour = vec4(1); }\n"
        self.assert_shader_refused(text, "own.frag", "'colour' at location 0")

    def test_output_missing(self):
        self.assert_shader_refused("#version 450\nvoid main() {}\n", "own.frag", "no output at location 0")

    def test_unknown_image(self):
        text = ("#version 450\nlayout(binding = 1) uniform sampler2D nosuch;\n" +
                OUTPUTS % "texelFetch(nosuch, ivec2(0), 0)")
        self.assert_shader_refused(text, "own.frag", "'nosuch'", "dist_view")

    def test_image_of_another_kind(self):
        text = ("#version 450\nlayout(binding = 1) uniform isampler2D dist_view;\n" +
                OUTPUTS % "vec4(texelFetch(dist_view, ivec2(0), 0))")
        self.assert_shader_refused(text, "own.frag", "'dist_view'", "wrong kind")

    def test_unknown_value_in_the_block(self):
        text = ("#version 450\nlayout(std140, binding = 0) uniform Block { float nosuch; };\n" +
                OUTPUTS % "vec4(nosuch)")
        self.assert_shader_refused(text, "own.frag", "'nosuch'", "max_distance_m")


class WhatDoesNotEnd(ShaderTest):
    def test_loop_without_a_way_out_is_refused_by_line(self):
        self.assert_shader_refused(ENTRY % "    while (true) { hit.lookups += 1; }", "own.frag:8", "never ends")

    def test_loop_that_only_the_data_ends_is_cut_and_told(self):
        text = ENTRY % ("    float x = load_dist_view(gl_FragCoord.xy);\n"
                        "    while (x > 0.0) { x = x * 0.5 + 1.0; hit.lookups += 1; hit.steps += 1; }\n"
                        "    hit.p_px = vec2(x);")
        for device in kit.DEVICES:
            with self.subTest(device):
                result = self.trace_with(text, device)
                self.assert_exit(1, result)
                outcomes = kit.read_json(self.path("out/results.json"))["summary"]["outcomes"]
                self.assertTrue({"limiter", "timeout"} & set(outcomes), outcomes)


class WrongAnswers(ShaderTest):
    def test_nonsense_in_the_record_fails_checks_and_nothing_else(self):
        text = ("#version 450\nlayout(location = 0) out ivec2 a;\nlayout(location = 1) out vec4 b;\n"
                "layout(location = 2) out uvec4 c;\n"
                "void main() { a = ivec2(-7, 1000000); b = vec4(0.0 / (gl_FragCoord.x - gl_FragCoord.x)); "
                "c = uvec4(77, 1u << 31, 2, 3); }\n")
        for device in kit.DEVICES:
            with self.subTest(device):
                result = self.trace_with(text, device)
                self.assert_exit(1, result)
                self.assert_closing_line(result)
                self.assert_whole_files(self.path("out"))

    def test_the_kits_own_shader_in_its_own_place_passes(self):
        result = self.trace("--replace", f"trace_dda={kit.SOURCE}/shaders/trace_dda.frag")
        self.assert_exit(0, result)


if __name__ == "__main__":
    kit.main()
