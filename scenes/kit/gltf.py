"""Writes NAME.gltf (readable JSON) and NAME.bin beside it."""

import json
import math
import struct

from .colours import linear

FLOAT, UNSIGNED_SHORT = 5126, 5123


def quaternion(axis, degrees):
    half = math.radians(degrees) / 2
    return [round(component * math.sin(half), 9) for component in axis] + [round(math.cos(half), 9)]


def product(a, b):
    """The quaternion that turns by b, then by a."""
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return [round(value, 9) for value in (
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
        aw * bw - ax * bx - ay * by - az * bz,
    )]


def yaw(degrees):
    return quaternion((0, 1, 0), degrees)


def pitch(degrees):
    return quaternion((1, 0, 0), degrees)


def roll(degrees):
    return quaternion((0, 0, 1), degrees)


class Gltf:
    def __init__(self, name):
        self.name = name
        self.binary = bytearray()
        self.root = {
            "asset": {"version": "2.0", "generator": "ssrkit scenes/make_scenes.py"},
            "scene": 0,
            "scenes": [{"name": name, "nodes": []}],
        }
        self.accessors_of = {}
        self.meshes_of = {}

    def _append(self, member, value):
        self.root.setdefault(member, []).append(value)
        return len(self.root[member]) - 1

    def _view(self, data, **more):
        self.binary += b"\0" * (-len(self.binary) % 4)
        view = {"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data), **more}
        self.binary += data
        return self._append("bufferViews", view)

    def _vectors(self, vectors, kind, bounds=False):
        size = len(vectors[0])
        data = struct.pack(f"<{size * len(vectors)}f", *(x for vector in vectors for x in vector))
        accessor = {"bufferView": self._view(data, target=34962), "componentType": FLOAT,
                    "count": len(vectors), "type": kind}
        if bounds:
            stored = list(struct.iter_unpack(f"<{size}f", data))
            accessor["min"] = [min(column) for column in zip(*stored)]
            accessor["max"] = [max(column) for column in zip(*stored)]
        return self._append("accessors", accessor)

    def _plain_vectors(self, vectors):
        """Vectors that are not vertices."""
        size = len(vectors[0])
        data = struct.pack(f"<{size * len(vectors)}f", *(x for vector in vectors for x in vector))
        return self._append("accessors", {"bufferView": self._view(data), "componentType": FLOAT,
                                          "count": len(vectors), "type": f"VEC{size}"})

    def _accessors(self, shape):
        """One set of accessors for each shape, however many materials it is shown in."""
        if id(shape) not in self.accessors_of:
            indices = struct.pack(f"<{len(shape.indices)}H", *shape.indices)
            attributes = {
                "POSITION": self._vectors(shape.positions, "VEC3", bounds=True),
                "NORMAL": self._vectors(shape.normals, "VEC3"),
                "TEXCOORD_0": self._vectors(shape.uvs, "VEC2"),
            }
            view = self._view(indices, target=34963)
            accessor = {"bufferView": view, "componentType": UNSIGNED_SHORT, "count": len(shape.indices), "type": "SCALAR"}
            # The shape is kept too: its id() must not be given to another one.
            self.accessors_of[id(shape)] = (attributes, self._append("accessors", accessor), shape)
        return self.accessors_of[id(shape)][:2]

    def texture(self, png, wrap=10497):
        image = self._append("images", {"bufferView": self._view(png), "mimeType": "image/png"})
        sampler = self._append("samplers", {"wrapS": wrap, "wrapT": wrap})
        return self._append("textures", {"source": image, "sampler": sampler})

    def material(self, name, colour=(255, 255, 255), metallic=0, roughness=0.8, texture=None, normal=None,
                 normal_scale=1, emissive=None, double_sided=False, traced=False):
        pbr = {"baseColorFactor": linear(colour) + [1], "metallicFactor": metallic, "roughnessFactor": roughness}
        if texture is not None:
            pbr["baseColorTexture"] = {"index": texture}
        material = {"name": name, "pbrMetallicRoughness": pbr}
        if normal is not None:
            material["normalTexture"] = {"index": normal, "scale": normal_scale}
        if emissive is not None:
            material["emissiveFactor"] = linear(emissive)
        if double_sided:
            material["doubleSided"] = True
        if traced:
            material["extras"] = {"ssrkit_mirror": True}
        return self._append("materials", material)

    def mirror(self, name, **more):
        return self.material(name, (238, 240, 244), metallic=1, roughness=0, **more)

    def add(self, name, shape, material, at=None, turn=None, scale=None):
        attributes, indices = self._accessors(shape)
        key = (id(shape), material)
        if key not in self.meshes_of:
            primitive = {"attributes": attributes, "indices": indices, "material": material}
            self.meshes_of[key] = self._append("meshes", {"primitives": [primitive]})
        node = {"name": name, "mesh": self.meshes_of[key]}
        self._node(node, at, turn, scale)

    def camera(self, name, fov_y, near, far, at=None, turn=None):
        lens = {"yfov": fov_y, "znear": near, "zfar": far}
        camera = self._append("cameras", {"name": name, "type": "perspective", "perspective": lens})
        self._node({"name": name, "camera": camera}, at, turn)

    def animate(self, path, times, values, interpolation="LINEAR"):
        """Moves the node that was added last; `path` is "translation", "rotation" or "scale"."""
        if "animations" not in self.root:
            self._append("animations", {"name": "all", "samplers": [], "channels": []})
        animation = self.root["animations"][0]
        data = struct.pack(f"<{len(times)}f", *times)
        keys = {"bufferView": self._view(data), "componentType": FLOAT, "count": len(times), "type": "SCALAR",
                "min": [min(times)], "max": [max(times)]}
        animation["samplers"].append({"input": self._append("accessors", keys), "interpolation": interpolation,
                                      "output": self._plain_vectors(values)})
        animation["channels"].append({"sampler": len(animation["samplers"]) - 1,
                                      "target": {"node": len(self.root["nodes"]) - 1, "path": path}})

    def sun(self, elevation, azimuth, intensity=3.0, colour=(1, 0.97, 0.92)):
        """Light from `elevation` degrees above the horizon; azimuth 0 shines along -z, 90 along -x."""
        lights = self.root.setdefault("extensions", {}).setdefault("KHR_lights_punctual", {"lights": []})["lights"]
        self.root["extensionsUsed"] = ["KHR_lights_punctual"]
        lights.append({"name": "sun", "type": "directional", "intensity": intensity, "color": list(colour)})
        self._node({"name": "sun", "extensions": {"KHR_lights_punctual": {"light": len(lights) - 1}}},
                   turn=product(yaw(azimuth), pitch(-elevation)))

    def _node(self, node, at=None, turn=None, scale=None):
        for key, value in (("translation", at), ("rotation", turn), ("scale", scale)):
            if value is not None:
                node[key] = list(value)
        self.root["scenes"][0]["nodes"].append(self._append("nodes", node))

    def write(self, folder):
        folder.mkdir(parents=True, exist_ok=True)
        self.root["buffers"] = [{"uri": self.name + ".bin", "byteLength": len(self.binary)}]
        (folder / (self.name + ".bin")).write_bytes(bytes(self.binary))
        text = json.dumps(self.root, indent=1)
        (folder / (self.name + ".gltf")).write_text(text + "\n", encoding="utf-8", newline="\n")
