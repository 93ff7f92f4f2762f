"""Renders a mesh and a camera that `plumbline reference --export-mesh --export-camera` wrote with Blender's Cycles:

    blender -b -P tests/end_to_end/blender_frame.py -- MESH.ply CAMERA.json OUT.exr

OUT.exr: multilayer, 32-bit float, one ray through the center of each pixel; passes Combined, Z, Position, Normal, UV
and IndexOB (the object_id of the mesh file). `plumbline compare REFERENCE.exr OUT.exr` reads it directly.

The world isn't rotated: Y stays up. Blender 3.4; needs NumPy.
"""
import json
import math
import os
import sys

import bpy
from mathutils import Matrix

try:
    import numpy
except ImportError:  # Debian's package of Blender doesn't bring it
    sys.exit("blender_frame.py: NumPy is missing; try: apt install python3-numpy")

VERTEX = numpy.dtype([("position", "<f4", 3), ("normal", "<f4", 3), ("st", "<f4", 2)])
FACE = numpy.dtype([("count", "u1"), ("corners", "<i4", 3), ("object_id", "<i4")])


def read_mesh(path):
    """Vertices and faces of a .ply file that plumbline wrote; other files aren't supported."""
    with open(path, "rb") as file:
        counts = {}
        for line in iter(file.readline, b"end_header\n"):
            words = line.split()
            if not words:
                sys.exit(f"{path}: has no end of a PLY header")
            if words[0] == b"element":
                counts[words[1].decode()] = int(words[2])
        vertices = numpy.fromfile(file, VERTEX, counts["vertex"])
        faces = numpy.fromfile(file, FACE, counts["face"])
    if len(vertices) != counts["vertex"] or len(faces) != counts["face"] or not (faces["count"] == 3).all():
        sys.exit(f"{path}: is truncated, or not as plumbline writes it")
    return vertices, faces


def add_object(name, object_id, vertices, triangles):
    """An object with some of the triangles and the vertices they use; st becomes UV, normals are smooth."""
    used, corners = numpy.unique(triangles, return_inverse=True)
    corners = corners.astype(numpy.int32).ravel()
    mesh = bpy.data.meshes.new(name)
    mesh.vertices.add(len(used))
    mesh.vertices.foreach_set("co", vertices["position"][used].ravel())
    mesh.loops.add(len(corners))
    mesh.loops.foreach_set("vertex_index", corners)
    mesh.polygons.add(len(triangles))
    mesh.polygons.foreach_set("loop_start", numpy.arange(0, len(corners), 3, dtype=numpy.int32))
    mesh.polygons.foreach_set("loop_total", numpy.full(len(triangles), 3, dtype=numpy.int32))
    mesh.polygons.foreach_set("use_smooth", numpy.ones(len(triangles), dtype=bool))
    mesh.update(calc_edges=True)
    uvs = mesh.uv_layers.new(name="st")
    uvs.data.foreach_set("uv", vertices["st"][used][corners].ravel())
    obj = bpy.data.objects.new(name, mesh)
    obj.pass_index = object_id
    bpy.context.scene.collection.objects.link(obj)


def add_camera(description):
    """The camera of the JSON. Blender's camera also looks down its -Z with +Y up."""
    data = bpy.data.cameras.new("camera")
    data.sensor_fit = "VERTICAL"
    if description["projection"] == "perspective":
        data.angle_y = math.radians(description["fov_y_degrees"])
    else:
        data.type = "ORTHO"
        data.sensor_fit = "AUTO"  # ortho_scale is then the longer side of the picture
        data.ortho_scale = description["view_height"] * max(1.0, description["aspect"])
    data.clip_start, data.clip_end = 1e-3, 1e6
    camera = bpy.data.objects.new("camera", data)
    camera.matrix_world = Matrix(description["view_to_world"])
    bpy.context.scene.collection.objects.link(camera)
    bpy.context.scene.camera = camera


def add_lights(lights):
    for light in lights:
        sun = light["kind"] == "directional"
        data = bpy.data.lights.new(light["name"], "SUN" if sun else "POINT")
        obj = bpy.data.objects.new(light["name"], data)
        if sun:
            data.energy, data.angle = math.pi, 0.0
            toward = Matrix.Identity(3).col[2].copy()
            toward[:] = light["to_light"]
            obj.rotation_euler = toward.to_track_quat("Z", "Y").to_euler()
        else:
            data.energy, data.shadow_soft_size = 100.0, 0.0
            obj.location = light["position"]
        bpy.context.scene.collection.objects.link(obj)


def set_up_render(description, out):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = 1
    scene.cycles.use_adaptive_sampling = False
    scene.cycles.use_denoising = False
    # One sample per pixel within the filter, whose width is Blender's minimum, 0.01 pixels.
    scene.cycles.pixel_filter_type = "BOX"
    scene.cycles.filter_width = 0.01
    scene.cycles.max_bounces = 0
    scene.render.resolution_x, scene.render.resolution_y = description["width"], description["height"]
    scene.render.resolution_percentage = 100
    scene.render.pixel_aspect_x = scene.render.pixel_aspect_y = 1
    scene.render.film_transparent = True
    scene.render.use_compositing = scene.render.use_sequencer = False
    layer = bpy.context.view_layer
    for name in ("z", "position", "normal", "uv", "object_index"):
        setattr(layer, "use_pass_" + name, True)
    scene.render.image_settings.file_format = "OPEN_EXR_MULTILAYER"
    scene.render.image_settings.color_depth = "32"
    scene.render.image_settings.exr_codec = "ZIP"
    scene.render.filepath = os.path.abspath(out)


def main():
    arguments = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []
    if len(arguments) != 3:
        sys.exit("usage: blender -b -P blender_frame.py -- MESH.ply CAMERA.json OUT.exr")
    mesh_file, camera_file, out = arguments
    with open(camera_file, encoding="utf-8") as file:
        description = json.load(file)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    vertices, faces = read_mesh(mesh_file)
    for entry in description["objects"]:
        triangles = faces["corners"][faces["object_id"] == entry["id"]]
        add_object(entry["name"], entry["id"], vertices, triangles)
    add_camera(description)
    add_lights(description["lights"])
    set_up_render(description, out)
    bpy.ops.render.render(write_still=True)


# After an exception in a script Blender exits with 0 unless --python-exit-code is given; sys.exit works
# without it.
try:
    main()
except Exception as error:  # noqa: BLE001: every exception must set the exit code
    sys.exit(f"blender_frame.py: {error}")
