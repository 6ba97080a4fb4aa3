"""Shaders that are wrong all over the image, in the place of each stage: `run` must tell, and end with 1."""

import os
import shutil

import kit

STAGES = ("naive", "refined", "dda", "hiz")
END = "  trace_end(hit);"


def pass_of(stage):
    return "trace_hiz_tuned" if stage == "hiz" else f"trace_{stage}"


def shader(stage):
    with open(os.path.join(kit.SOURCE, "shaders", f"{pass_of(stage)}.frag")) as file:
        return file.read()


class WrongTest(kit.KitTest):
    def run_with(self, stage, change, scene="clutter", size="160x90", add=()):
        text = shader(stage)
        changed = change(text)
        self.assertNotEqual(text, changed)
        file = self.write(f"{stage}.frag", changed)
        return self.trace("--replace", f"{pass_of(stage)}={file}", *add, scene=scene, stage=stage, size=size)

    def assert_told(self, result, *words):
        self.assert_exit(1, result)
        for word in words:
            self.assertIn(word, result.out, str(result))


class EveryStage(WrongTest):
    """What the kit's own shaders pass, and one that is wrong everywhere does not."""

    def test_that_hits_nothing(self):
        for stage in STAGES:
            with self.subTest(stage):
                result = self.run_with(stage, lambda text: text.replace(
                    END, "  if (hit.ray_class == RAY_HIT) hit = ray_without_hit(RAY_OFFSCREEN, hit.lookups, hit.steps);\n"
                    + END))
                self.assert_told(result, "fail: standard.", "likely    no ray hits anything")

    def test_that_hits_its_own_texel(self):
        for stage in STAGES:
            with self.subTest(stage):
                result = self.run_with(stage, lambda text: text.replace(
                    END, "  if (hit.ray_class == RAY_HIT) { hit.texel = ivec2(gl_FragCoord.xy); hit.p_px = "
                    "gl_FragCoord.xy; }\n" + END))
                self.assert_told(result, "fail: standard.no_self_hit")

    def test_whose_hits_are_one_texel_aside(self):
        for stage in STAGES:
            with self.subTest(stage):
                result = self.run_with(stage, lambda text: text.replace(
                    END, "  if (hit.ray_class == RAY_HIT && hit.texel.x > 0) { hit.texel.x -= 1; hit.p_px.x -= 1.0; }\n"
                    + END))
                self.assert_told(result, "fail: standard.")
                if stage != "naive":  # whose hits lie behind the oracle's anyway
                    self.assert_told(result, "likely    all hits are off by the same texel")

    def test_whose_thickness_has_the_wrong_sign(self):
        for stage in STAGES:
            with self.subTest(stage):
                result = self.run_with(stage, lambda text: text.replace("trace_parameters()", "turned()").replace(
                    "void main() {", "TraceParameters turned() {\n  TraceParameters wrong = trace_parameters();\n"
                    "  wrong.thickness_m = -wrong.thickness_m;\n  return wrong;\n}\n\nvoid main() {"))
                self.assert_told(result, "fail: standard.")


class ClosedForms(WrongTest):
    """A scene that is a formula is held to it, at any size."""

    MOVED = staticmethod(lambda text: text.replace(
        END, "  if (hit.ray_class == RAY_HIT && hit.texel.y > 0) { hit.texel.y -= 1; hit.p_px.y -= 1.0; }\n" + END))

    def test_are_asked_of_the_built_in_scenes(self):
        result = self.run_with("hiz", self.MOVED, scene="m1", size="128x72")
        self.assert_told(result, "fail: standard.closed_form m1 128x72", "against closed-form",
                         "likely    all hits are off by the same texel")

    def test_are_not_asked_of_rays_that_they_do_not_know(self):
        result = self.run_with("hiz", self.MOVED, scene="m1", add=("--param", "max_distance_m=2"))
        self.assertNotIn("closed_form", result.out)

    def test_are_not_asked_of_a_file_of_that_name(self):
        for name in ("clutter.gltf", "clutter.bin"):
            source = os.path.join(kit.SOURCE, "scenes", "clutter", name)
            shutil.copy(source, self.path(name.replace("clutter.gltf", "m1.gltf")))
        result = self.trace(scene=self.path("m1.gltf"), stage="hiz")
        self.assert_exit(0, result)


if __name__ == "__main__":
    kit.main()
