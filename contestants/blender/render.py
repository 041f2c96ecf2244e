"""Renders the ambient-occlusion pass of Cycles or Eevee, with depth and normals, as a request asks for it:

    blender --background --factory-startup --python-exit-code 1 --python render.py -- cycles|eevee REQUEST.json

The picture is a multi-layer EXR; what is seen through a pixel is seen through its centre, as by the truth.
"""
import json
import math
import sys

import bpy
import numpy
from mathutils import Matrix

# Blender 3.4's importer asks for a name that numpy has dropped in 1.24; Debian 12 has these two together.
if not hasattr(numpy, "bool"):
    numpy.bool = bool


def read_arguments():
    engine, path = sys.argv[sys.argv.index("--") + 1:]
    with open(path, encoding="utf-8") as file:
        return engine, json.load(file)


def add_scene(request):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=request["scene"])


def add_camera(scene, request):
    """The importer turns glTF's y up into Blender's z up; the camera looks down its own -z in both."""
    asked = request["camera"]
    data = bpy.data.cameras.new("view")
    data.clip_start, data.clip_end = asked["near_m"], asked["far_m"]
    data.sensor_fit = "VERTICAL"
    if asked["projection"] == "orthographic":
        data.type = "ORTHO"
        data.ortho_scale = 2 * asked["half_height_m"]
    else:
        data.angle_y = math.radians(asked["fovy_deg"])
    numbers = asked["world_to_camera"]
    camera_from_world = Matrix([numbers[4 * row:4 * row + 4] for row in range(4)])
    view = bpy.data.objects.new("view", data)
    view.matrix_world = Matrix.Rotation(math.radians(90), 4, "X") @ camera_from_world.inverted()
    scene.collection.objects.link(view)
    scene.camera = view


def choose_cycles(scene, request):
    scene.world.light_settings.distance = request["radius_m"]
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.samples = request["parameters"]["samples"]
    cycles.seed = request["seed"] % (1 << 31)
    cycles.use_adaptive_sampling = False
    cycles.use_denoising = False
    cycles.max_bounces = 0
    # No ray leaves the neighbourhood of the pixel's centre. A box would be a pixel wide, whatever its width says.
    cycles.pixel_filter_type = "BLACKMAN_HARRIS"
    cycles.filter_width = 0.01
    if request["parameters"]["triangle_normals"]:
        shade_flat()


def shade_flat():
    """Gives every surface the normals of its triangles, as the truth has them."""
    for thing in bpy.data.objects:
        if thing.type != "MESH":
            continue
        mesh = thing.data
        mesh.use_auto_smooth = False  # else the file's own normals count
        mesh.polygons.foreach_set("use_smooth", [False] * len(mesh.polygons))


def choose_eevee(scene, request):
    """Its occlusion is by horizons in the depth buffer (GTAO), over several samples a pixel."""
    scene.render.engine = "BLENDER_EEVEE"
    eevee = scene.eevee
    eevee.use_gtao = True
    eevee.gtao_distance = request["radius_m"]
    eevee.gtao_factor = 1
    eevee.gtao_quality = request["parameters"]["quality"]
    eevee.use_gtao_bent_normals = False
    eevee.use_gtao_bounce = False
    eevee.taa_render_samples = request["parameters"]["samples"]
    scene.render.filter_size = 0  # all samples at the pixel's centre


def choose_picture(scene, request):
    render = scene.render
    render.resolution_x, render.resolution_y = request["width"], request["height"]
    render.resolution_percentage = 100
    render.image_settings.file_format = "OPEN_EXR_MULTILAYER"
    render.image_settings.color_depth = "32"
    render.filepath = request["output"]
    layer = scene.view_layers[0]
    layer.name = "ViewLayer"
    layer.use_pass_ambient_occlusion = layer.use_pass_z = layer.use_pass_normal = True


def main():
    engine, request = read_arguments()
    add_scene(request)
    scene = bpy.context.scene
    add_camera(scene, request)
    scene.world = bpy.data.worlds.new("open")
    {"cycles": choose_cycles, "eevee": choose_eevee}[engine](scene, request)
    choose_picture(scene, request)
    bpy.ops.render.render(write_still=True)


main()
