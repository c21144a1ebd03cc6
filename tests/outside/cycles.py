# SPDX-License-Identifier: MIT
"""Renders a glTF file with Blender 3.4's Cycles, made to compute what `lueur reference` does.

    blender -b --factory-startup -P cycles.py -- SCENE.glb OUT.exr --size 128x128 --spp 256

OUT.exr has 32-bit layers `ViewLayer.DiffDir`, `ViewLayer.DiffInd`, `ViewLayer.DiffCol`, the same
for `Gloss`, `ViewLayer.Emit` and `ViewLayer.Depth`, in the file's own units: cd/m2.
"""
import argparse
import math
import sys

import bpy
import numpy

numpy.bool = bool  # Blender 3.4's importer uses the name that numpy 1.24 has dropped


def parse_arguments():
    parser = argparse.ArgumentParser(prog="cycles.py")
    parser.add_argument("scene")
    parser.add_argument("output")
    parser.add_argument("--size", default="128x128")
    parser.add_argument("--spp", type=int, default=256)
    parser.add_argument("--bounces", type=int, default=1)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--surfaces", choices=["lobes", "imported"], default="lobes",
                        help="Lambert's law, and GGX on metal, or what the importer makes")
    arguments = parser.parse_args(sys.argv[sys.argv.index("--") + 1:])
    arguments.width, arguments.height = (int(n) for n in arguments.size.split("x"))
    return arguments


def import_scene(path):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    # COMPAT keeps candela and lux as numbers: a point light of 4 pi I watts has I watts per
    # steradian, and radiances come out in the file's cd/m2.
    bpy.ops.import_scene.gltf(filepath=path, convert_lighting_mode="COMPAT")
    scene = bpy.context.scene
    scene.camera = next(o for o in scene.objects if o.type == "CAMERA")
    scene.frame_set(0)  # the imported animation's time 0
    bpy.context.view_layer.update()


def replace_lobes(material):
    """Puts one plain lobe in the place of Principled's, whose diffuse lobe is not Lambert's."""
    tree = material.node_tree
    principled = next(n for n in tree.nodes if n.type == "BSDF_PRINCIPLED")
    if principled.inputs["Metallic"].default_value == 1.0:
        lobe = tree.nodes.new("ShaderNodeBsdfGlossy")
        lobe.distribution = "GGX"
        lobe.inputs["Roughness"].default_value = principled.inputs["Roughness"].default_value
    else:
        lobe = tree.nodes.new("ShaderNodeBsdfDiffuse")
        lobe.inputs["Roughness"].default_value = 0.0
    glow = tree.nodes.new("ShaderNodeEmission")
    glow.inputs["Strength"].default_value = principled.inputs["Emission Strength"].default_value
    for source, shader in (("Base Color", lobe), ("Emission", glow)):
        if principled.inputs[source].links:
            tree.links.new(principled.inputs[source].links[0].from_socket, shader.inputs["Color"])
        else:
            shader.inputs["Color"].default_value = principled.inputs[source].default_value
    both = tree.nodes.new("ShaderNodeAddShader")
    tree.links.new(lobe.outputs[0], both.inputs[0])
    tree.links.new(glow.outputs[0], both.inputs[1])
    output = next(n for n in tree.nodes if n.type == "OUTPUT_MATERIAL")
    tree.links.new(both.outputs[0], output.inputs["Surface"])


def make_cone(light_object):
    """Turns a spot into a point light with the falloff that KHR_lights_punctual recommends:

    ((cos - cos_outer) / (cos_inner - cos_outer))^2, clamped to 0 and 1. Blender's own is another.
    """
    light = light_object.data
    outer = 0.5 * light.spot_size
    inner = (1.0 - light.spot_blend) * outer
    light.type = "POINT"
    light = light_object.data
    light.use_nodes = True
    tree = light.node_tree
    geometry = tree.nodes.new("ShaderNodeNewGeometry")
    cosine = tree.nodes.new("ShaderNodeVectorMath")
    cosine.operation = "DOT_PRODUCT"
    axis = -light_object.matrix_world.to_3x3().col[2].normalized()
    tree.links.new(geometry.outputs["Incoming"], cosine.inputs[0])  # from the light to the point
    cosine.inputs[1].default_value = axis
    ramp = tree.nodes.new("ShaderNodeMapRange")
    ramp.clamp = True
    ramp.inputs["From Min"].default_value = math.cos(outer)
    ramp.inputs["From Max"].default_value = math.cos(inner)
    tree.links.new(cosine.outputs["Value"], ramp.inputs["Value"])
    square = tree.nodes.new("ShaderNodeMath")
    square.operation = "MULTIPLY"
    tree.links.new(ramp.outputs["Result"], square.inputs[0])
    tree.links.new(ramp.outputs["Result"], square.inputs[1])
    emission = next(n for n in tree.nodes if n.type == "EMISSION")
    tree.links.new(square.outputs["Value"], emission.inputs["Strength"])


def prepare(surfaces):
    for material in bpy.data.materials:
        if surfaces == "lobes" and material.use_nodes:
            replace_lobes(material)
            # As our scenes ask for, but the importer only hears when minFilter does, too.
            for node in material.node_tree.nodes:
                if node.type == "TEX_IMAGE":
                    node.interpolation = "Closest"
        # Glow is found by paths alone. Sampled as a light, a thin strip of it gives too little in
        # Cycles 3.4, as an integral of the form factor tells.
        material.cycles.sample_as_light = False
    for thing in bpy.context.scene.objects:
        if thing.type == "LIGHT":
            if thing.data.type == "SPOT":
                make_cone(thing)
            if thing.data.type == "SUN":
                thing.data.angle = 0.0
            else:
                thing.data.shadow_soft_size = 0.0
        elif thing.type == "MESH":
            # Rays start on the surface itself.
            thing.cycles.shadow_terminator_geometry_offset = 0.0
            thing.cycles.shadow_terminator_offset = 0.0


def set_up_cycles(arguments):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.render.resolution_x = arguments.width
    scene.render.resolution_y = arguments.height
    scene.render.resolution_percentage = 100
    scene.world = None  # black
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.seed = arguments.seed
    cycles.samples = arguments.spp
    # All that would trade truth for less noise is off.
    cycles.use_adaptive_sampling = False
    cycles.use_denoising = False
    cycles.light_sampling_threshold = 0.0
    cycles.sample_clamp_direct = 0.0
    cycles.sample_clamp_indirect = 0.0
    cycles.blur_glossy = 0.0
    cycles.caustics_reflective = True
    cycles.use_fast_gi = False
    # Rays stay within a hundredth of a pixel around its centre. (A box would be a pixel wide.)
    cycles.pixel_filter_type = "GAUSSIAN"
    cycles.filter_width = 0.01
    cycles.max_bounces = arguments.bounces
    cycles.diffuse_bounces = arguments.bounces
    cycles.glossy_bounces = arguments.bounces

    layer = bpy.context.view_layer
    layer.use_pass_z = True
    layer.use_pass_emit = True
    for lobe in ("diffuse", "glossy"):
        for part in ("direct", "indirect", "color"):
            setattr(layer, f"use_pass_{lobe}_{part}", True)
    image = scene.render.image_settings
    image.file_format = "OPEN_EXR_MULTILAYER"
    image.color_depth = "32"
    image.exr_codec = "ZIP"
    scene.render.use_file_extension = False
    scene.render.filepath = arguments.output


def main():
    arguments = parse_arguments()
    import_scene(arguments.scene)
    prepare(arguments.surfaces)
    set_up_cycles(arguments)
    bpy.ops.render.render(write_still=True)


main()
