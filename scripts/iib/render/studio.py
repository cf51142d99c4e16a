"""Runs inside Blender: lights the surfaces of a run and renders a picture of each time.

blender --background --python studio.py -- job.json
"""

import json
import pathlib
import sys

import bpy
from mathutils import Vector

# What the studio looks like.
INTO = Vector((0.45, 1.0, -0.42)).normalized()  # the way the camera looks
DISTANCE = 1.75  # of the camera from the middle, in sizes of the scene
FIELD_RAD = 0.70  # angle that the picture is wide
WATER_IOR, ICE_IOR = 1.333, 1.31
WATER_TINT = (0.45, 0.82, 0.95)  # what a scene's size of water leaves of white light
ICE_COLOUR, ICE_ROUGHNESS, ICE_MILKY = (0.90, 0.96, 1.0), 0.15, 0.6
GROUND_COLOUR, OBJECT_COLOUR, SOLID_COLOUR = (
    (0.22, 0.25, 0.29),
    (0.30, 0.32, 0.36),
    (0.75, 0.38, 0.14),
)
HEAT_SHARE = 0.3  # of the colour by temperature in that of water, in scenes with heat
STEAM_THICKNESS = 6.0  # how much of light a scene's size of steam scatters
SKY_COLOUR, SKY_STRENGTH = (0.45, 0.62, 0.85), 0.35
LAMPS = (  # place and width in sizes of the scene, power in watts per square metre of that size
    ((-1.2, -1.0, 2.0), 1.0, 110.0),
    ((1.6, 0.6, 1.2), 1.4, 45.0),
)
SHARP_RAD = 0.5  # edges of colliders and solids that turn more are sharp
GLASS_SHINE = 0.3  # of vessels, seen from the side
BOUNCES = 16


def read_series(folder, name):
    """File of each time, to the millisecond."""
    path = folder / (name + ".series")
    if not path.is_file():
        return {}
    entries = json.loads(path.read_text())["files"]
    return {round(1000 * entry["time"]): folder / entry["name"] for entry in entries}


def new_material(name):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    nodes = material.node_tree.nodes
    nodes.clear()
    return nodes, material.node_tree.links, nodes.new("ShaderNodeOutputMaterial"), material


def see_through(nodes, links, shader, tint):
    """Lets light pass straight on to what lies behind, which a path tracer hardly ever finds."""
    path = nodes.new("ShaderNodeLightPath")
    transparent = nodes.new("ShaderNodeBsdfTransparent")
    transparent.inputs["Color"].default_value = (*tint, 1.0)
    either = nodes.new("ShaderNodeMath")
    either.operation = "MAXIMUM"
    links.new(path.outputs["Is Shadow Ray"], either.inputs[0])
    links.new(path.outputs["Is Diffuse Ray"], either.inputs[1])
    mix = nodes.new("ShaderNodeMixShader")
    links.new(either.outputs[0], mix.inputs[0])
    links.new(shader.outputs[0], mix.inputs[1])
    links.new(transparent.outputs[0], mix.inputs[2])
    return mix


def glass(nodes, ior, roughness, colour=(1.0, 1.0, 1.0)):
    shader = nodes.new("ShaderNodeBsdfGlass")
    shader.inputs["IOR"].default_value = ior
    shader.inputs["Roughness"].default_value = roughness
    shader.inputs["Color"].default_value = (*colour, 1.0)
    return shader


def colour_by_temperature(nodes, links, shader):
    """White mixed with the colours of the vertices, which surfaces of scenes with heat have."""
    vertex = nodes.new("ShaderNodeVertexColor")
    mix = nodes.new("ShaderNodeMixRGB")
    mix.inputs["Fac"].default_value = HEAT_SHARE
    mix.inputs["Color1"].default_value = (1.0, 1.0, 1.0, 1.0)
    links.new(vertex.outputs["Color"], mix.inputs["Color2"])
    links.new(mix.outputs["Color"], shader.inputs["Color"])


def water(size_m, heat):
    nodes, links, out, material = new_material("water")
    clear = glass(nodes, WATER_IOR, 0.0)
    if heat:
        colour_by_temperature(nodes, links, clear)
    shader = see_through(nodes, links, clear, WATER_TINT)
    links.new(shader.outputs[0], out.inputs["Surface"])
    inside = nodes.new("ShaderNodeVolumeAbsorption")
    inside.inputs["Color"].default_value = (*WATER_TINT, 1.0)
    inside.inputs["Density"].default_value = 2.0 / size_m
    links.new(inside.outputs[0], out.inputs["Volume"])
    return material


def ice():
    nodes, links, out, material = new_material("ice")
    milk = nodes.new("ShaderNodeBsdfDiffuse")
    milk.inputs["Color"].default_value = (*ICE_COLOUR, 1.0)
    mix = nodes.new("ShaderNodeMixShader")
    mix.inputs[0].default_value = ICE_MILKY
    links.new(glass(nodes, ICE_IOR, ICE_ROUGHNESS, ICE_COLOUR).outputs[0], mix.inputs[1])
    links.new(milk.outputs[0], mix.inputs[2])
    shader = see_through(nodes, links, mix, ICE_COLOUR)
    links.new(shader.outputs[0], out.inputs["Surface"])
    return material


def steam(size_m):
    nodes, links, out, material = new_material("steam")
    inside = nodes.new("ShaderNodeVolumeScatter")
    inside.inputs["Density"].default_value = STEAM_THICKNESS / size_m
    links.new(inside.outputs[0], out.inputs["Volume"])
    return material


def vessel():
    """Glass so thin that it does not bend light: only its reflection is seen."""
    nodes, links, out, material = new_material("glass")
    shine = nodes.new("ShaderNodeBsdfGlossy")
    shine.inputs["Roughness"].default_value = 0.0
    clear = nodes.new("ShaderNodeBsdfTransparent")
    facing = nodes.new("ShaderNodeLayerWeight")  # the same from inside, unlike Fresnel's
    facing.inputs["Blend"].default_value = 0.25
    share = nodes.new("ShaderNodeMath")
    share.operation = "MULTIPLY"
    share.inputs[1].default_value = GLASS_SHINE
    links.new(facing.outputs["Facing"], share.inputs[0])
    mix = nodes.new("ShaderNodeMixShader")
    links.new(share.outputs[0], mix.inputs[0])
    links.new(clear.outputs[0], mix.inputs[1])
    links.new(shine.outputs[0], mix.inputs[2])
    shader = see_through(nodes, links, mix, (0.97, 0.98, 0.98))
    links.new(shader.outputs[0], out.inputs["Surface"])
    return material


def opaque(name, colour, roughness):
    nodes, links, out, material = new_material(name)
    shader = nodes.new("ShaderNodeBsdfPrincipled")
    shader.inputs["Base Color"].default_value = (*colour, 1.0)
    shader.inputs["Roughness"].default_value = roughness
    links.new(shader.outputs[0], out.inputs["Surface"])
    return material


def drop(objects):
    for one in objects:
        data = one.data
        bpy.data.objects.remove(one)
        if data.users == 0:
            bpy.data.meshes.remove(data)


def load_mesh(path, material):
    bpy.ops.import_mesh.ply(filepath=str(path))
    one = bpy.context.selected_objects[0]
    one.data.materials.clear()
    one.data.materials.append(material)
    one.data.polygons.foreach_set("use_smooth", [True] * len(one.data.polygons))
    return one


def load_parts(path, materials):
    """Objects of an OBJ file; each keeps its place in the scene and has one of the materials."""
    bpy.ops.import_scene.obj(
        filepath=str(path), axis_forward="Y", axis_up="Z", use_split_objects=True
    )
    parts = list(bpy.context.selected_objects)
    for part in parts:
        name = part.data.materials[0].name.split(".")[0] if part.data.materials else "object"
        part.data.materials.clear()
        if name in materials:
            part.data.materials.append(materials[name])
        else:
            part.hide_render = True
        part["look"] = name
        part.data.use_auto_smooth, part.data.auto_smooth_angle = True, SHARP_RAD
    return parts


def bounds(objects):
    corners = [one.matrix_world @ Vector(corner) for one in objects for corner in one.bound_box]
    low = Vector([min(c[axis] for c in corners) for axis in range(3)])
    high = Vector([max(c[axis] for c in corners) for axis in range(3)])
    return low, high


def add_floor(low, size_m, material):
    bpy.ops.mesh.primitive_plane_add(size=60 * size_m, location=(0, 0, low.z - 0.002 * size_m))
    bpy.context.object.data.materials.append(material)


def add_light(middle, size_m):
    world = bpy.context.scene.world or bpy.data.worlds.new("sky")
    bpy.context.scene.world = world
    world.use_nodes = True
    background = world.node_tree.nodes["Background"]
    background.inputs["Color"].default_value = (*SKY_COLOUR, 1.0)
    background.inputs["Strength"].default_value = SKY_STRENGTH
    for place, width, power in LAMPS:
        lamp = bpy.data.lights.new("lamp", "AREA")
        lamp.size = width * size_m
        lamp.energy = power * size_m * size_m
        one = bpy.data.objects.new("lamp", lamp)
        one.location = middle + size_m * Vector(place)
        one.rotation_euler = (middle - one.location).to_track_quat("-Z", "Y").to_euler()
        bpy.context.collection.objects.link(one)


def add_camera(middle, size_m):
    camera = bpy.data.cameras.new("camera")
    camera.angle = FIELD_RAD
    camera.clip_start, camera.clip_end = 0.001 * size_m, 1000 * size_m
    one = bpy.data.objects.new("camera", camera)
    one.location = middle - DISTANCE * size_m * INTO
    one.rotation_euler = INTO.to_track_quat("-Z", "Y").to_euler()
    bpy.context.collection.objects.link(one)
    bpy.context.scene.camera = one


def set_up_renderer(job):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = job["samples"]
    scene.cycles.use_adaptive_sampling = True
    scene.cycles.use_denoising = False  # Debian's Blender has no denoiser
    scene.cycles.max_bounces = BOUNCES
    scene.cycles.transmission_bounces = BOUNCES
    scene.cycles.transparent_max_bounces = BOUNCES
    scene.cycles.sample_clamp_indirect = 4.0  # no single bright dots
    scene.cycles.caustics_refractive = scene.cycles.caustics_reflective = False
    scene.render.use_persistent_data = True
    scene.render.resolution_x, scene.render.resolution_y = job["size"]
    scene.view_settings.view_transform = "Filmic"
    scene.view_settings.look = "High Contrast"


def main():
    job = json.loads(pathlib.Path(sys.argv[sys.argv.index("--") + 1]).read_text())
    folder = pathlib.Path(job["folder"])
    bpy.ops.wm.read_factory_settings(use_empty=True)
    set_up_renderer(job)
    materials = {
        "glass": vessel(),
        "ground": opaque("ground", GROUND_COLOUR, 0.5),
        "object": opaque("object", OBJECT_COLOUR, 0.4),
        "solid": opaque("solid", SOLID_COLOUR, 0.5),
        "ice": ice(),
    }
    parts = load_parts(folder / "colliders.obj", materials)
    series = {name: read_series(folder, f"{name}.ply") for name in ("water", "ice", "steam")}
    first = sorted(series["water"])[0]
    seen = [load_mesh(series["water"][first], materials["ice"])]
    heat = len(seen[0].data.color_attributes) > 0
    low, high = bounds([p for p in parts if p["look"] in ("glass", "object")] + seen)
    drop(seen)
    middle, size_m = (low + high) / 2, (high - low).length
    materials["water"], materials["steam"] = water(size_m, heat), steam(size_m)
    if not any(p["look"] == "ground" for p in parts):
        add_floor(low, size_m, materials["ground"])
    add_light(middle, size_m)
    add_camera(middle, size_m)
    for number, time_s in enumerate(job["times"]):
        at = round(1000 * time_s)
        shown = []
        for name, files in series.items():
            if at in files and files[at].stat().st_size > 1000:
                shown.append(load_mesh(files[at], materials[name]))
        solids = sorted(folder.glob("solids_*.obj"))
        if solids:
            index = sorted(series["water"]).index(at)
            shown += load_parts(solids[index], materials)
        bpy.context.scene.render.filepath = str(folder / f"picture_{number:05d}.png")
        bpy.ops.render.render(write_still=True)
        print("picture", number, flush=True)
        drop(shown)


main()
