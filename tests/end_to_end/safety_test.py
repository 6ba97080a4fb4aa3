"""What a shader does that its answer does not tell: it leaves its arrays, its loops are cut, the API is misused."""

import kit

OUTPUTS = """#version 450
layout(location = 0) out ivec2 hit_texel;
layout(location = 1) out vec4 hit_point;
layout(location = 2) out uvec4 ray_work;
void main() {
  hit_texel = ivec2(-1);
  ray_work = uvec4(3, 0, 0, 0);
%s
}
"""

# Writes and reads a local array before its beginning, at an index that only the picture decides.
OUTSIDE = OUTPUTS % """
  float list[4] = float[4](1.0, 2.0, 3.0, 4.0);
  int index = int(gl_FragCoord.x) - 40;
  list[index] = 7.0;
  hit_point = vec4(list[0], list[1], list[2], list[3]);
"""

# Reads far behind the uniform block.
OUTSIDE_BLOCK = OUTPUTS.replace("void main", """layout(std140, binding = 0) uniform Block { mat4 clip_from_view; };
void main""") % """
  hit_point = clip_from_view[int(gl_FragCoord.x) * 100];
"""

# Adds up a series, so that the number of turns shows in the answer.
TURNS = OUTPUTS.replace("%s", """
  float sum = 0.0;
  for (int i = 0; i < %d + int(gl_FragCoord.x); ++i) {
    sum += 1.0;
  }
  hit_point = vec4(sum);
""")


class SafetyTest(kit.KitTest):
    def checks(self, metric):
        """Outcome and message of the extra check, by device."""
        checks = kit.read_json(self.path("out/results.json"))["checks"]
        found = {}
        for check in checks:
            if check["id"].endswith("." + metric):
                found[check["device"]] = (check["outcome"], check["message"])
        return found

    def trace_safely(self, text, device):
        self.write("own.frag", text)
        return self.trace("--safety", "--replace", "walk=own.frag", stage="walk", device=device, size="16x12")


class Arrays(SafetyTest):
    def test_indices_outside_are_told(self):
        for device in kit.DEVICES:
            with self.subTest(device):
                result = self.trace_safely(OUTSIDE, device)
                self.assert_exit(1, result)
                outcome, message = self.checks("out_of_bounds")[device]
                self.assertEqual("fail", outcome, str(result))
                self.assertIn("reads or writes outside", message)

    def test_the_kits_own_shaders_stay_inside(self):
        for device in kit.DEVICES:
            with self.subTest(device):
                result = self.trace("--safety", stage="hiz", device=device)
                self.assert_exit(0, result)
                self.assertEqual("pass", self.checks("out_of_bounds")[device][0])
                self.assertEqual("pass", self.checks("counted_loops")[device][0])


class Loops(SafetyTest):
    def test_seventy_thousand_turns_meet_the_limiter(self):
        for device in kit.DEVICES:
            with self.subTest(device):
                result = self.trace_safely(TURNS % 70000, device)
                self.assert_exit(1, result)
                outcome, message = self.checks("counted_loops")[device]
                self.assertEqual("limiter", outcome, str(result))
                self.assertIn("65,535", message)

    def test_fifty_thousand_do_not(self):
        for device in kit.DEVICES:
            with self.subTest(device):
                self.trace_safely(TURNS % 50000, device)
                self.assertEqual("pass", self.checks("counted_loops")[device][0])


class Validation(SafetyTest):
    def validate(self, checks, **options):
        return self.trace("--validate", checks, stage="hiz", device="vk-lavapipe", **options)

    def test_the_kit_keeps_the_rules(self):
        for checks in ("core,sync", "gpu"):
            with self.subTest(checks):
                result = self.validate(checks)
                self.assert_exit(0, result)
                self.assertEqual("pass", self.checks("validation")["vk-lavapipe"][0])

    def test_a_read_behind_the_uniform_block_is_told_while_the_shader_runs(self):
        self.write("own.frag", OUTSIDE_BLOCK)
        result = self.trace("--safety", "--validate", "gpu", "--replace", "walk=own.frag", stage="walk",
                            device="vk-lavapipe", size="16x12")
        self.assert_exit(1, result)
        outcome, message = self.checks("validation")["vk-lavapipe"]
        self.assertEqual("fail", outcome)
        self.assertIn("access out of bounds", message)
        self.assertEqual("fail", self.checks("out_of_bounds")["vk-lavapipe"][0])

    def test_barriers_that_wait_for_nothing_are_hazards(self):
        result = self.validate("sync", env={"SSRKIT_FAULT": "barrier:"})
        self.assert_exit(1, result)
        outcome, message = self.checks("validation")["vk-lavapipe"]
        self.assertEqual("fail", outcome)
        self.assertIn("SYNC-HAZARD", message)

    def test_a_kind_of_check_that_nobody_knows(self):
        self.assert_refused(self.validate("core,speed"), "'speed'")


class Limits(SafetyTest):
    def test_a_pass_that_is_drawn_too_long_is_a_timeout_of_its_run(self):
        result = self.trace("--run-limit", "0.5", env={"SSRKIT_FAULT": "hang:draw trace_dda"})
        self.assert_exit(1, result)
        self.assertIn("timeout(run)", result.out)

    def test_a_shader_that_is_compiled_too_long_is_a_timeout_of_its_compilation(self):
        result = self.trace("--compile-limit", "0.5", env={"SSRKIT_FAULT": "hang:build trace_dda"})
        self.assert_exit(1, result)
        self.assertIn("timeout(compile)", result.out)


if __name__ == "__main__":
    kit.main()
