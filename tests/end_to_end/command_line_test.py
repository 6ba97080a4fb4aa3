"""What is typed wrong is named, and the nearest right word with it."""

import glob
import os
import tomllib

import kit


class CommandLineTest(kit.KitTest):
    def assert_refused_early(self, result, *words):
        self.assert_refused(result, *words)
        self.assertFalse(os.path.exists(self.path("out")), "something was written")


class Commands(CommandLineTest):
    def test_unknown_command_is_named(self):
        self.assert_refused(self.ssrkit("frobnicate"), "frobnicate", "run", "devices")

    def test_nearest_command_is_suggested(self):
        self.assert_refused(self.ssrkit("complie", "a.frag"), "complie", "did you mean 'compile'?")

    def test_no_command(self):
        self.assert_refused(self.ssrkit(), "ssrkit --help")

    def test_unknown_flag_is_named(self):
        self.assert_refused(self.ssrkit("run", "--frobnicate"), "--frobnicate")
        self.assert_refused(self.ssrkit("devices", "--nope"), "--nope")

    def test_nearest_flag_is_suggested(self):
        self.assert_refused(self.ssrkit("run", "--sceen", "m1"), "--sceen", "did you mean '--scene'?")

    def test_stray_word_is_named(self):
        self.assert_refused(self.ssrkit("run", "stray"), "stray")

    def test_flag_without_its_value(self):
        self.assert_refused(self.ssrkit("run", "--scene"), "--scene")

    def test_help_of_each_command(self):
        for command in ([], ["run"], ["test"], ["compare"], ["devices"], ["compile"]):
            with self.subTest(command):
                result = self.ssrkit(*command, "--help")
                self.assert_exit(0, result)
                self.assertIn("Usage", result.out)
                self.assertEqual("", result.err)

    def test_no_test_matches(self):
        self.assert_refused(self.ssrkit("test", "--only", "expect", "--filter", "nosuch"), "nosuch", "--list")

    def test_tags_choose_expectation_files(self):
        carried = {}
        for path in glob.glob(os.path.join(kit.SOURCE, "tests", "expect", "*.toml")):
            with open(path, "rb") as file:
                test = tomllib.load(file)["test"]
            carried[test["id"]] = set(test.get("tags", []))
        del carried["standard"]
        for tags in (("geometry",), ("closed-form", "cost")):
            result = self.ssrkit("test", "--list", *(word for tag in tags for word in ("--tag", tag)))
            self.assert_exit(0, result)
            wanted = sorted(test for test, of_test in carried.items() if of_test & set(tags))
            self.assertEqual(wanted, sorted(line.split()[0] for line in result.out.splitlines()))
        self.assert_refused(self.ssrkit("test", "--tag", "geometri", "--list"), "'geometri'", "--tag", "geometry",
                            "cost")
        self.assert_refused(self.ssrkit("test", "--tag", "geometry", "--filter", "hiz*"), "'hiz*'", "tags")
        self.assert_refused(self.ssrkit("test", "--tag", "geometry", "--only", "unit"), "--tag", "--only unit")

    def test_nothing_to_compile(self):
        self.assert_refused(self.ssrkit("compile", "nosuch.frag"), "nosuch.frag", "no such file")
        self.assert_refused(self.ssrkit("compile", self.write("text.txt", "")), "text.txt", ".frag")


class Names(CommandLineTest):
    def test_scene(self):
        self.assert_refused_early(self.trace(scene="clutterr"), "clutterr", "did you mean 'clutter'?")

    def test_stage(self):
        self.assert_refused_early(self.trace(stage="hizz"), "hizz", "did you mean 'hiz'?")

    def test_device(self):
        self.assert_refused_early(self.trace(device="gl-osmessa"), "gl-osmessa", "did you mean 'gl-osmesa'?")

    def test_empty_names(self):
        for option in ("scene", "stage", "device"):
            with self.subTest(option):
                self.assert_refused_early(self.trace(**{option: ""}), option)

    def test_scene_twice(self):
        self.assert_refused_early(self.trace("--scene", "m2"), "two scenes are called 'm2'")

    def test_device_and_stage_twice_are_run_once(self):
        result = self.trace("--device", "gl-osmesa", "--stage", "dda")
        self.assert_exit(0, result)
        traces = kit.read_json(self.path("out/results.json"))["traces"]
        self.assertEqual(1, len(traces))

    def test_camera(self):
        self.assert_refused(self.trace("--camera", "nosuch"), "nosuch", "its cameras are")

    def test_mirror(self):
        self.assert_refused(self.trace("--mirror", "nosuch"), "nosuch", "its materials are")

    def test_pass_to_replace(self):
        shader = self.write("a.frag", "#version 450\nvoid main() {}\n")
        self.assert_refused(self.trace("--replace", f"trace_ddaa={shader}"), "trace_ddaa", "did you mean 'trace_dda'?")

    def test_pass_that_the_run_does_not_draw(self):
        shader = self.write("a.frag", "#version 450\nvoid main() {}\n")
        for name in ("trace_walk", "shadow", "ao", "pyramid_base", "accumulate"):
            with self.subTest(name):
                self.assert_refused(self.trace("--replace", f"{name}={shader}"), f"'{name}'", "this run does not draw it",
                                    "trace_dda")


class Sizes(CommandLineTest):
    def test_what_is_no_size(self):
        for size in ("0x0", "-1x5", "5x-1", "640", "640x", "x360", "", "640X360", "4.5x4", "nanxnan", " 4x4", "+4x4",
                     "1x1x1", "0x10x10", "640x360 "):
            with self.subTest(size):
                self.assert_refused_early(self.trace(size=size), f"'{size}'", "--size", "640x360")

    def test_too_large(self):
        for size in ("20000x20000", "16385x1", "1x16385", "99999999999999999999x1", "4294967297x1"):
            with self.subTest(size):
                self.assert_refused_early(self.trace(size=size), f"'{size}'", "16384")

    def test_the_smallest_works(self):
        result = self.trace(size="1x1")
        self.assert_exit(0, result)
        self.assert_closing_line(result)


class Parameters(CommandLineTest):
    def test_values_out_of_range_are_named_with_the_range(self):
        for name, values in {"thickness_m": ("nan", "-1", "-inf", "text", "", " 1", "1e400", "1,5", "0x10", "1=2"),
                             "max_distance_m": ("0", "nan", "-1"), "step_m": ("inf", "-1"), "step_count": ("-1", "1e9"),
                             "lookup_budget": ("inf", "-1", "1e9"), "stride_px": ("0", "nan"), "jitter": ("2", "-0.1"),
                             "max_mip": ("-2", "99"), "bisection_count": ("33",), "origin_bias": ("-1", "inf"),
                             "thickness_rel": ("inf", "nan"), "step_growth": ("0.5", "5")}.items():
            for value in values:
                with self.subTest(name=name, value=value):
                    self.assert_refused_early(self.trace("--param", f"{name}={value}"), f"'{name}'", f"'{value}'",
                                              "a number from")

    def test_whole_numbers(self):
        self.assert_refused_early(self.trace("--param", "stride_px=1.5"), "stride_px", "'1.5'", "whole number")

    def test_nearest_name_is_suggested(self):
        self.assert_refused_early(self.trace("--param", "thicknes_m=1"), "thicknes_m", "did you mean 'thickness_m'?")

    def test_form_is_one_of_two_words(self):
        self.assert_refused_early(self.trace("--param", "form=texbook"), "texbook", "'textbook' or 'tuned'")

    def test_not_name_equals_value(self):
        for text in ("thickness_m", ""):
            with self.subTest(text):
                self.assert_refused_early(self.trace("--param", text), "--param", "NAME=VALUE")

    def test_the_ends_of_the_ranges_work(self):
        ends = ("thickness_m=inf", "max_distance_m=inf", "lookup_budget=60000", "jitter=0", "stride_px=1")
        result = self.trace(*(word for end in ends for word in ("--param", end)))
        self.assert_exit(0, result)

    def test_a_step_too_short_for_the_rays_is_noted(self):
        result = self.trace("--param", "step_m=1e-6", stage="naive")
        self.assertIn("the most that there are; where step_m = 1e-06 would have needed more", result.err)
        self.assertEqual("", self.trace("--param", "step_m=0.1", stage="naive").err)


    def test_a_relative_thickness_alone_is_the_whole_thickness(self):
        for more, thickness_m in (((), 0), (("--param", "thickness_m=0.25"), 0.25)):
            self.assert_exit(0, self.trace("--param", "thickness_rel=0.05", *more))
            (trace,) = kit.read_json(self.path("out/results.json"))["traces"]
            self.assertEqual((thickness_m, 0.05), (trace["parameters"]["thickness_m"],
                                                   trace["parameters"]["thickness_rel"]))


class Replacements(CommandLineTest):
    def test_not_pass_equals_file(self):
        for text in ("trace_dda", "=a.frag", "trace_dda=", ""):
            with self.subTest(text):
                self.assert_refused_early(self.trace("--replace", text), "--replace", "PASS=FILE")

    def test_missing_file(self):
        self.assert_refused(self.trace("--replace", "trace_dda=nosuch.frag"), "nosuch.frag", "no such file")

    def test_folder(self):
        self.assert_refused(self.trace("--replace", f"trace_dda={self.folder}"), "it is a folder")


if __name__ == "__main__":
    kit.main()
