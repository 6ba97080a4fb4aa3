"""Scene files that cannot be drawn are refused in a sentence by the command line (the loader has its own tests)."""

import base64
import json
import math
import os
import struct

import kit

CORNERS = ((-2.0, -2.0, -3.0), (2.0, -2.0, -3.0), (0.0, 2.0, -3.0))


def triangle(corners=CORNERS):
    """One triangle three metres ahead as a glTF 2.0 document with its data inside."""
    data = b"".join(struct.pack("<fff", *corner) for corner in corners)
    uri = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    return {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
            "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                           "min": [-2, -2, -3], "max": [2, 2, -3]}],
            "bufferViews": [{"buffer": 0, "byteLength": len(data)}],
            "buffers": [{"byteLength": len(data), "uri": uri}]}


def binary(document, data=b""):
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text
    if data:
        chunks += struct.pack("<I4s", len(data), b"BIN\0") + data
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


class SceneFileTest(kit.KitTest):
    def write_scene(self, content, name="scene.gltf"):
        return self.write(name, content if isinstance(content, (str, bytes)) else json.dumps(content))

    def assert_scene_refused(self, content, *words, name="scene.gltf"):
        self.write_scene(content, name)
        self.assert_refused(self.trace(scene=name), name, *words)
        self.assertFalse(os.path.exists(self.path("out/scene")), "files of a scene that was not traced")


class WhatIsNoScene(SceneFileTest):
    def test_missing_file(self):
        self.assert_refused(self.trace(scene="nosuch.gltf"), "nosuch.gltf", "no such file")

    def test_folder(self):
        os.mkdir(self.path("place"))
        self.assert_refused(self.trace(scene="place"), "place", "it is a folder")

    def test_pipe_does_not_block(self):
        os.mkfifo(self.path("pipe.gltf"))
        self.assert_refused(self.trace(scene="pipe.gltf"), "pipe.gltf")

    def test_empty_file(self):
        self.assert_scene_refused("", "the file is empty")

    def test_text(self):
        self.assert_scene_refused("hello", name="scene.glb")

    def test_gltf_1(self):
        self.assert_scene_refused({"asset": {"version": "1.0"}, "scenes": {}}, "glTF '1.0'", "glTF 2.0")

    def test_no_triangle(self):
        self.assert_scene_refused({"asset": {"version": "2.0"}}, "no triangle")

    def test_bytes_that_are_no_text(self):
        self.assert_scene_refused(b"{\"asset\": \"\xff\xfe\x00\"}")


class Damage(SceneFileTest):
    def test_glb_cut_short_anywhere(self):
        whole = binary(triangle())
        for length in (4, 11, 12, 20, len(whole) // 2, len(whole) - 1):
            with self.subTest(length=length):
                self.assert_scene_refused(whole[:length], name="scene.glb")

    def test_positions_that_are_not_finite(self):
        for value in (math.nan, math.inf):
            with self.subTest(value=value):
                self.assert_scene_refused(triangle(((value, 0, 0),) + CORNERS[1:]))

    def test_accessor_past_its_buffer(self):
        document = triangle()
        document["accessors"][0]["count"] = 3_000_000
        self.assert_scene_refused(document)

    def test_node_that_is_its_own_child(self):
        document = triangle()
        document["nodes"][0]["children"] = [0]
        self.assert_scene_refused(document)

    def test_indices_of_things_that_are_not_there(self):
        for path in (("scenes", 0, "nodes", 0), ("nodes", 0, "mesh"), ("accessors", 0, "bufferView"),
                     ("bufferViews", 0, "buffer")):
            with self.subTest(path=path):
                document = triangle()
                place = document
                for key in path[:-1]:
                    place = place[key]
                place[path[-1]] = 77
                self.assert_scene_refused(document)

    def test_buffer_outside_the_folder(self):
        document = triangle()
        document["buffers"][0]["uri"] = "../../../../../../etc/passwd"
        self.assert_scene_refused(document)

    def test_buffer_file_missing(self):
        document = triangle()
        document["buffers"][0]["uri"] = "nosuch.bin"
        self.assert_scene_refused(document, "nosuch.bin")


class Defaults(SceneFileTest):
    def test_unknown_key_beside_the_scene_is_named_by_line_and_column(self):
        self.write_scene(triangle())
        self.write("scene.toml", "about = \"x\"\nthicknes_m = 1\n")
        self.assert_refused(self.trace(scene="scene.gltf"), "scene.toml:2:1", "did you mean 'thickness_m'?")

    def test_value_out_of_range(self):
        self.write_scene(triangle())
        self.write("scene.toml", "thickness_m = nan\n")
        self.assert_refused(self.trace(scene="scene.gltf"), "scene.toml:1:", "thickness_m")

    def test_no_toml(self):
        self.write_scene(triangle())
        self.write("scene.toml", "thickness_m = = 1\n")
        self.assert_refused(self.trace(scene="scene.gltf"), "scene.toml:1:")


class GoodScenes(SceneFileTest):
    def test_a_triangle_without_camera_light_or_material(self):
        self.write_scene(triangle())
        result = self.trace(scene="scene.gltf")
        self.assertIn(result.code, (0, 1), str(result))
        self.assertIn("out/scene/camera.json", ["out/" + name for name in self.assert_whole_files(self.path("out"))])

    def test_one_bad_scene_leaves_the_others_alone(self):
        self.write_scene("")
        result = self.trace("--scene", "m2", scene="scene.gltf")
        self.assert_exit(2, result)
        self.assertTrue(os.path.exists(self.path("out/m2/gl-osmesa/dda/hit.exr")))


if __name__ == "__main__":
    kit.main()
