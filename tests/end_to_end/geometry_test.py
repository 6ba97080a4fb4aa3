"""What the rays truly meet: the files and the table of a run, held to the closed form of m1 and to the triangles."""

import math
import os

import exr
import kit

VISIBLE, UNSAMPLED, SKY = 1, 2, 6
TRUE_HIT, MISSED_HIT, TRUE_MISS = 1, 3, 4


class Files(kit.KitTest):
    def test_m1_is_the_wall_turned_upside_down(self):
        self.assert_exit(0, self.trace(scene="m1", stage="walk", size="128x64"))
        image = exr.read(self.path("out/m1/oracle/geometry.exr"))
        self.assertEqual({"class", "px.x", "px.y", "t_m", "dist_view", "verdict"}, set(image.channels))
        rays = 0
        for y in range(64):
            for x in range(128):
                i = y * 128 + x
                values = {name: channel[i] for name, channel in image.channels.items()}
                if y < 40:  # the wall, which does not mirror: 5/8 of the height
                    self.assertEqual((0, -1, -1, -1, 0, 0), tuple(values[c] for c in ("class", "px.x", "px.y", "t_m",
                                                                                      "dist_view", "verdict")))
                    continue
                rays += 1
                self.assertEqual((VISIBLE, TRUE_HIT), (values["class"], values["verdict"]), (x, y))
                self.assertAlmostEqual(x + 0.5, values["px.x"], delta=1e-3)
                self.assertAlmostEqual(1.25 * 64 - (y + 0.5), values["px.y"], delta=1e-3)
                self.assertAlmostEqual(8, values["dist_view"], delta=1e-5)
                # From the floor at 2 / |Y| metres to the wall, along the viewing direction's mirror image.
                ndc_x, ndc_y = 2 * (x + 0.5) / 128 - 1, 1 - 2 * (y + 0.5) / 64
                length = math.sqrt(1 + (ndc_x * 2 / 2) ** 2 + (ndc_y / 2) ** 2)
                self.assertAlmostEqual((8 + 2 / ndc_y) * length, values["t_m"], delta=1e-4)
        self.assertEqual(24 * 128, rays)

    def test_results_json_adds_up(self):
        self.assert_exit(0, self.trace(scene="clutter", stage="hiz", size="160x90"))
        results = kit.read_json(self.path("out/results.json"))
        (row,) = results["geometry"]
        self.assertEqual(("clutter", "gl-osmesa", [160, 90]), (row["scene"], row["device"], row["size"]))
        self.assertEqual(row["rays"], sum(c["rays"] for c in row["true_classes"].values()))
        image = exr.read(self.path("out/clutter/oracle/geometry.exr"))
        names = ["VISIBLE", "UNSAMPLED", "OCCLUDED", "BACKFACE", "OFFSCREEN_TRUE", "SKY"]
        for number, name in enumerate(names, start=1):
            of_class = row["true_classes"][name]
            self.assertEqual(image.channels["class"].count(number), of_class["rays"], name)
            self.assertEqual(of_class["rays"], sum(of_class["oracle"].values()), name)
            of_trace = results["traces"][0]["true_classes"][name]
            self.assertEqual(of_class["rays"], of_trace["rays"])
            self.assertEqual(of_class["rays"], sum(of_trace["geometry"].values()))
            # hiz gives the exact walk's hits, so its hits are worth the same; ties may differ.
            self.assertEqual(of_class["rays"], of_trace["oracle"]["SAME"] + of_trace["oracle"]["AMBIGUOUS"], name)
        self.assertGreater(row["true_classes"]["VISIBLE"]["rays"], 0.5 * row["rays"])

    def test_the_oracles_record_names_as_many_ties_as_are_counted(self):
        self.assert_exit(0, self.trace(scene="clutter", stage="hiz", size="160x90"))
        hit = exr.read(self.path("out/clutter/oracle/hit.exr")).channels
        ties = [tie for tie, ray_class in zip(hit["tie"], hit["class"]) if ray_class > 1]  # of pixels with a ray
        (share,) = (check["value"] for check in kit.read_json(self.path("out/results.json"))["checks"]
                    if check["metric"] == "ambiguous_share")
        self.assertGreater(share, 0)
        self.assertAlmostEqual(share, sum(tie > 0 for tie in ties) / len(ties))
        self.assertLessEqual(set(hit["tie"]), {0, 1, 2, 3})

    def test_is_traced_over_the_first_device_alone(self):
        self.assert_exit(0, self.trace("--device", "vk-lavapipe", scene="m3", stage="walk"))
        results = kit.read_json(self.path("out/results.json"))
        self.assertEqual(["gl-osmesa"], [row["device"] for row in results["geometry"]])
        by_device = {trace["device"]: trace["true_classes"] for trace in results["traces"]}
        self.assertIsNone(by_device["vk-lavapipe"])
        self.assertIsNotNone(by_device["gl-osmesa"])


class WithoutTriangles(kit.KitTest):
    def test_a_gbuffer_made_by_others_has_no_geometry(self):
        self.assert_exit(0, self.trace(scene="m1", stage="walk", out="first"))
        result = self.trace("--gbuffer", self.path("first/m1/gl-osmesa"), scene=None, stage="walk", size=None)
        self.assert_exit(0, result)
        self.assertNotIn("can and cannot know", result.out)
        (folder,) = [name for name in os.listdir(self.path("out")) if os.path.isdir(self.path("out", name))]
        self.assertEqual(["hit.exr"], os.listdir(self.path("out", folder, "oracle")))
        self.assertEqual([], kit.read_json(self.path("out/results.json"))["geometry"])


class Table(kit.KitTest):
    def test_follows_the_runs_own_within_a_hundred_columns(self):
        result = self.trace(scene="m1", stage="dda", size="128x64")
        self.assert_exit(0, result)
        lines = result.out.splitlines()
        start = next(i for i, line in enumerate(lines) if line.startswith("What screen space can and cannot know"))
        self.assertLess(max(map(len, lines)), 101)
        self.assertEqual(["m1", "3072", "100.00", "0.00", "0.00", "0.00", "0.00", "0.00", "100.00", "0.00", "0.00",
                          "0.00"], lines[start + 3].split())
        self.assertIn("SAME", result.out)
        self.assert_closing_line(result)

    def test_json_is_the_whole_output(self):
        result = self.trace("--json", scene="m1", stage="dda")
        self.assert_exit(0, result)
        self.assertTrue(result.out.startswith("{"))


if __name__ == "__main__":
    kit.main()
