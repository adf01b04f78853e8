"""The way into Blender and out of it: materials, mesh objects, glTF files."""

import math

import bpy


def start_empty():
    bpy.ops.wm.read_factory_settings(use_empty=True)


def linear(channel):
    """Source: IEC 61966-2-1."""
    return channel / 12.92 if channel <= 0.04045 else ((channel + 0.055) / 1.055) ** 2.4


def make_material(name, color, roughness, metallic=0.0):
    """@param color "#rrggbb" as pictures write it"""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    material.use_backface_culling = True
    channels = [linear(int(color[i : i + 2], 16) / 255.0) for i in (1, 3, 5)]
    surface = material.node_tree.nodes["Principled BSDF"].inputs
    surface["Base Color"].default_value = (*channels, 1.0)
    surface["Roughness"].default_value = roughness
    surface["Metallic"].default_value = metallic
    return material


def make_object(name, parts, materials, smooth_degrees):
    """One mesh object of all parts; edges that bend less than `smooth_degrees` look round."""
    vertices, faces, material_of_face = [], [], []
    for part in parts:
        first = len(vertices)
        vertices.extend(part.vertices)
        faces.extend(tuple(first + i for i in face) for face in part.faces)
        material_of_face.extend([part.material] * len(part.faces))
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(vertices, [], faces)
    for material in materials:
        mesh.materials.append(material)
    mesh.polygons.foreach_set("material_index", material_of_face)
    mesh.polygons.foreach_set("use_smooth", [True] * len(faces))
    mesh.use_auto_smooth = True
    mesh.auto_smooth_angle = math.radians(smooth_degrees)
    assert not mesh.validate(), f"{name} has broken faces"
    made = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(made)
    return made


def export_glb(file):
    """Plain glTF 2.0 with Y up: no extensions, no textures."""
    bpy.ops.export_scene.gltf(
        filepath=str(file),
        export_format="GLB",
        export_yup=True,
        export_texcoords=False,
        export_image_format="NONE",
        export_colors=False,
        export_draco_mesh_compression_enable=False,
        export_optimize_animation_size=True,
    )
