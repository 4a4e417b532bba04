"""The scenes in which Lustro's path tracer and Mitsuba 3 are compared: each is written as Lustro's scene file and as Mitsuba's dictionary, with the same
triangles, lights and camera. A surface has no interpolated normals: those are treated differently by every renderer."""
import json
import math
import pathlib

import mitsuba as mi
import numpy as np

mi.set_log_level(mi.LogLevel.Error)

# Scattering surfaces a path meets; Mitsuba counts the segments of a path, the one from the eye included.
BOUNCES = 16
SKY_SIZE = (512, 256)


def read_obj(file):
    """Vertices, and the triangles of each material: what the Cornell box needs, whose indices count from the end."""
    vertices, faces, material = [], {}, ""
    for line in pathlib.Path(file).read_text(encoding="utf-8").splitlines():
        words = line.split("#")[0].split()
        if words[:1] == ["v"]:
            vertices.append([float(w) for w in words[1:4]])
        elif words[:1] == ["usemtl"]:
            material = words[1]
        elif words[:1] == ["f"]:
            corners = [int(w.split("/")[0]) for w in words[1:]]
            corners = [c - 1 if c > 0 else len(vertices) + c for c in corners]
            faces.setdefault(material, []).extend([corners[0], corners[i], corners[i + 1]] for i in range(1, len(corners) - 1))
    return np.array(vertices), {name: np.array(f) for name, f in faces.items()}


def read_ascii_ply(file):
    """Vertices and triangles of the Stanford bunny."""
    lines = pathlib.Path(file).read_text(encoding="ascii").splitlines()
    counts = {words[1]: int(words[2]) for words in (line.split() for line in lines[:20]) if words[:1] == ["element"]}
    begin = lines.index("end_header") + 1
    middle = begin + counts["vertex"]
    vertices = np.array([line.split()[:3] for line in lines[begin:middle]], dtype=np.float64)
    return vertices, np.array([line.split()[1:4] for line in lines[middle:middle + counts["face"]]], dtype=np.int64)


def write_obj(file, vertices, faces):
    used, faces = np.unique(faces, return_inverse=True)
    with open(file, "w", encoding="utf-8") as out:
        out.writelines(f"v {x!r} {y!r} {z!r}\n" for x, y, z in np.asarray(vertices[used], dtype=np.float32).tolist())
        out.writelines(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in faces.reshape(-1, 3).tolist())


def sky_radiance(direction):
    """A sky with a broad sun, a second light at its side and a dim ground; smooth, so that nobody's texels matter."""
    sun, side = np.array([0.48, 0.64, 0.6]), np.array([-0.8, 0.36, 0.48])
    height = direction[..., 1:2]
    light = np.array([0.35, 0.5, 0.8]) * (0.55 + 0.45 * height)
    light = light + np.array([40.0, 34.0, 26.0]) * np.exp(60 * (direction @ sun - 1))[..., None]
    return light + np.array([2.0, 1.0, 3.0]) * np.exp(12 * (direction @ side - 1))[..., None]


def sky_picture(u, v):
    """Lustro's convention: the middle is -z, the top +y, the right of the middle +x."""
    phi, theta = (u - 0.5) * 2 * math.pi, v * math.pi
    phi, theta = np.meshgrid(phi, theta)
    direction = np.stack([np.sin(phi) * np.sin(theta), np.cos(theta), -np.cos(phi) * np.sin(theta)], axis=-1)
    return sky_radiance(direction).astype(np.float32)


class Scene:
    """name: of the files; vertices, parts: {material: triangles}; materials: {name: {"kind": "lambert" | "mirror" | "glass", "color", "emission"}}."""

    def __init__(self, name, vertices, parts, materials, camera, has_sky, pixels):
        self.name, self.parts, self.materials, self.camera, self.has_sky, self.pixels = name, parts, materials, camera, has_sky, pixels
        self.vertices = np.asarray(vertices, dtype=np.float32)

    def write(self, folder, albedo_of=None):
        """The scene file of Lustro; albedo_of: (material, factor) that falsifies one of them. Returns its path."""
        folder = pathlib.Path(folder)
        materials = {}
        for name, faces in self.parts.items():
            write_obj(folder / f"{self.name}_{name}.obj", self.vertices, faces)
        for name, m in self.materials.items():
            factor = albedo_of[1] if albedo_of and albedo_of[0] == name else 1.0
            color = [c * factor for c in m["color"]]
            black = [0, 0, 0]
            materials[name] = {"lambert": {"ambient": black, "diffuse": color, "specular": black, "emission": m.get("emission", black), "lighting": "lambert"},
                               "mirror": {"ambient": black, "diffuse": black, "specular": color, "illumination": 3},
                               "glass": {"ambient": black, "diffuse": black, "specular": [1, 1, 1], "illumination": 7, "refraction": 1.5}}[m["kind"]]
        scene = {"image": {"width": self.pixels, "height": self.pixels, "background": "#000000"},
                 "camera": self.camera | {"near": 0.01, "far": 100},
                 "shading": {"interpolation": "flat", "two_sided": True}, "ambient": [0, 0, 0], "lights": [],
                 "materials": materials, "objects": [{"name": name, "mesh": f"{self.name}_{name}.obj", "material": name} for name in self.parts]}
        if self.has_sky:
            width, height = SKY_SIZE
            picture = sky_picture((np.arange(width) + 0.5) / width, (np.arange(height) + 0.5) / height)
            mi.Bitmap(picture).write(str(folder / "sky.exr"))
            scene["environment"] = {"file": "sky.exr"}
        path = folder / f"{self.name}.json"
        path.write_text(json.dumps(scene, indent=1), encoding="utf-8")
        return path

    def load(self):
        """The scene of Mitsuba, in the variant that is set."""
        camera = self.camera
        scene = {"type": "scene",
                 "integrator": {"type": "path", "max_depth": BOUNCES + 1},
                 "sensor": {"type": "perspective", "fov": camera["fov"], "fov_axis": "y", "near_clip": 0.01, "far_clip": 100,
                            "to_world": mi.ScalarTransform4f().look_at(origin=camera["eye"], target=camera["target"], up=[0, 1, 0]),
                            "film": {"type": "hdrfilm", "width": self.pixels, "height": self.pixels, "rfilter": {"type": "box"}, "pixel_format": "rgb",
                                     "component_format": "float32"}}}
        for name, faces in self.parts.items():
            material = self.materials[name]
            if "emission" in material:
                # Emission has a front in Mitsuba; ours shines both ways. The backs lie one thousandth behind.
                normal = np.cross(*(self.vertices[faces[0, i]] - self.vertices[faces[0, 0]] for i in (1, 2)))
                behind = self.vertices - 1e-4 * normal / np.linalg.norm(normal)
                scene[name] = self._mesh(name, self.vertices, faces, material)
                scene[name + "_back"] = self._mesh(name + "_back", behind, faces[:, ::-1], material)
            else:
                scene[name] = self._mesh(name, self.vertices, faces, material)
        if self.has_sky:
            width, height = SKY_SIZE
            # Mitsuba's rows lie on v = 0 .. 1, and its middle is +z with -x at the right.
            picture = sky_picture((np.arange(width) + 0.5) / width - 0.5, np.arange(height) / (height - 1))
            scene["sky"] = {"type": "envmap", "bitmap": mi.Bitmap(picture), "to_world": mi.ScalarTransform4f()}
        return mi.load_dict(scene)

    @staticmethod
    def _mesh(name, vertices, faces, material):
        kind, color = material["kind"], {"type": "rgb", "value": list(material["color"])}
        inner = {"lambert": {"type": "diffuse", "reflectance": color}, "mirror": {"type": "conductor", "material": "none", "specular_reflectance": color},
                 "glass": {"type": "dielectric", "int_ior": 1.5, "ext_ior": 1.0}}[kind]
        props = mi.Properties()
        props["bsdf"] = mi.load_dict(inner if kind == "glass" else {"type": "twosided", "bsdf": inner})
        if "emission" in material:
            props["emitter"] = mi.load_dict({"type": "area", "radiance": {"type": "rgb", "value": list(material["emission"])}})
        props["face_normals"] = True
        used, faces = np.unique(faces, return_inverse=True)
        mesh = mi.Mesh(name, len(used), faces.size // 3, props)
        values = mi.traverse(mesh)
        values["vertex_positions"] = np.ascontiguousarray(vertices[used], dtype=np.float32).ravel()
        values["faces"] = faces.astype(np.uint32).ravel()
        values.update()
        return mesh


WALLS = {"floor": (0.725, 0.71, 0.68), "ceiling": (0.725, 0.71, 0.68), "backWall": (0.725, 0.71, 0.68), "leftWall": (0.63, 0.065, 0.05),
         "rightWall": (0.14, 0.45, 0.091), "light": (0.0, 0.0, 0.0)}


def cornell(assets, boxes, pixels):
    """The Cornell box; boxes: the kind of the two."""
    vertices, parts = read_obj(assets / "obj/cornell_box/CornellBox-Original.obj")
    if boxes == "glass":  # whose bottoms shall not coincide with the floor
        vertices[np.unique(np.concatenate([parts["shortBox"], parts["tallBox"]])), 1] += 0.02
    materials = {name: {"kind": "lambert", "color": color} for name, color in WALLS.items()}
    materials["light"]["emission"] = (17, 12, 4)
    for name in ("shortBox", "tallBox"):
        materials[name] = {"kind": boxes, "color": (0.725, 0.71, 0.68)}
    return Scene(f"cornell_{boxes}", vertices, parts, materials, {"eye": [0, 1, 3.6], "target": [0, 1, 0], "fov": 39}, False, pixels)


def bunny(assets, kind, pixels):
    """The bunny on a floor under the sky."""
    vertices, faces = read_ascii_ply(assets / "ply/stanford_bunny/bun_zipper.ply")
    vertices = (vertices - [-0.017, vertices.min(axis=0)[1], 0]) * 10
    if kind == "glass":
        vertices[:, 1] += 0.05
    floor = np.array([[-3, 0, -3], [-3, 0, 3], [3, 0, 3], [3, 0, -3]], dtype=np.float64)
    ground = np.array([[0, 1, 2], [0, 2, 3]]) + len(vertices)
    materials = {"bunny": {"kind": kind, "color": (0.7, 0.6, 0.5)}, "ground": {"kind": "lambert", "color": (0.4, 0.4, 0.45)}}
    return Scene(f"bunny_{kind}", np.concatenate([vertices, floor]), {"bunny": faces, "ground": ground}, materials,
                 {"eye": [0.6, 1.6, 3.6], "target": [0, 0.7, 0], "fov": 32}, True, pixels)
