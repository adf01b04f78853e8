"""A passer-by in a straw hat: an armature of thirteen bones, a mesh that it bends, and the clip "walk".

The clip takes one second, in place. The face looks along -y here, +z in glTF.
"""

import math

import bpy
from mathutils import Matrix, Quaternion

from authoring.blender_files import make_material, make_object
from authoring.parts import ellipsoid, moved, revolve, scaled

TUNIC, SKIN, TROUSERS, STRAW = range(4)
HIP, KNEE, ANKLE = 0.93, 0.5, 0.09
SHOULDER, ELBOW, WRIST = 1.43, 1.15, 0.9
LEG_X, ARM_X = 0.095, 0.222
FRAMES = 24  # of the clip, which is as many per second

# Name: parent, foot, tip.
BONES = {
    "hips": (None, (0, 0, HIP), (0, 0, 1.08)),
    "spine": ("hips", (0, 0, 1.08), (0, 0, 1.5)),
    "head": ("spine", (0, 0, 1.5), (0, 0, 1.8)),
}
for side, sign in (("left", 1), ("right", -1)):
    leg, arm = sign * LEG_X, sign * ARM_X
    BONES[f"thigh_{side}"] = ("hips", (leg, 0, HIP), (leg, 0, KNEE))
    BONES[f"shin_{side}"] = (f"thigh_{side}", (leg, 0, KNEE), (leg, 0, ANKLE))
    BONES[f"foot_{side}"] = (f"shin_{side}", (leg, 0, ANKLE), (leg, -0.18, 0.03))
    BONES[f"arm_{side}"] = ("spine", (arm, 0, SHOULDER), (arm, 0, ELBOW))
    BONES[f"forearm_{side}"] = (f"arm_{side}", (arm, 0, ELBOW), (arm, 0, WRIST))


def limb(x, heights_and_radii, material):
    """A round limb along z, from its lower end to its upper end, with rounded ends."""
    (low, low_radius), (high, high_radius) = heights_and_radii[0], heights_and_radii[-1]
    profile = [
        (0.0, low - 0.7 * low_radius), (0.7 * low_radius, low - 0.45 * low_radius),
        *((radius, height) for height, radius in heights_and_radii),
        (0.7 * high_radius, high + 0.6 * high_radius), (0.0, high + 0.9 * high_radius),
    ]
    return moved(revolve(profile, 8, material), (x, 0.0, 0.0))


def leg_part(x):
    radii = [
        (ANKLE + 0.02, 0.046), (0.32, 0.06), (KNEE - 0.05, 0.056), (KNEE, 0.06), (KNEE + 0.05, 0.062),
        (HIP - 0.07, 0.09),
    ]
    return limb(x, radii, TROUSERS)


def arm_part(x):
    radii = [(WRIST, 0.036), (ELBOW - 0.04, 0.042), (ELBOW, 0.045), (ELBOW + 0.04, 0.046), (SHOULDER - 0.04, 0.06)]
    return limb(x, radii, TUNIC)


def torso_part():
    profile = [
        (0.0, 0.82), (0.19, 0.825), (0.185, 0.93), (0.155, 1.08), (0.18, 1.28), (0.215, 1.4), (0.17, 1.47),
        (0.075, 1.51), (0.0, 1.52),
    ]
    return scaled(revolve(profile, 14, TUNIC), (1.0, 0.68, 1.0))


def shoe_part(x):
    profile = [(0.0, 0.0), (0.95, 0.0), (1.0, 0.3), (0.8, 0.8), (0.0, 1.0)]
    return moved(scaled(revolve(profile, 10, TROUSERS), (0.055, 0.135, 0.1)), (x, -0.06, 0.0))


def hat_part():
    profile = [
        (0.0, 1.675), (0.1, 1.68), (0.25, 1.665), (0.25, 1.678), (0.128, 1.705), (0.115, 1.76), (0.08, 1.795),
        (0.0, 1.8),
    ]
    return revolve(profile, 14, STRAW)


def eased(height, low, high):
    share = min(max((height - low) / (high - low), 0.0), 1.0)
    return share * share * (3.0 - 2.0 * share)


def bend(lower, upper, joint, reach):
    """Weights of a part that bends at the height `joint`: the bone below it, the bone above it."""
    def weigh(vertex):
        share = eased(vertex[2], joint - reach, joint + reach)
        return {lower: 1.0 - share, upper: share}
    return weigh


def stiff(bone):
    return lambda vertex: {bone: 1.0}


def body():
    """Pairs of a part and the weights of its vertices."""
    pairs = [
        (torso_part(), bend("hips", "spine", 1.08, 0.15)),
        (limb(0.0, [(1.5, 0.055), (1.56, 0.052)], SKIN), stiff("head")),
        (ellipsoid((0.0, -0.015, 1.66), (0.092, 0.105, 0.125), 6, 12, SKIN), stiff("head")),
        (hat_part(), stiff("head")),
    ]
    for side, sign in (("left", 1), ("right", -1)):
        leg, arm = sign * LEG_X, sign * ARM_X
        pairs += [
            (leg_part(leg), bend(f"shin_{side}", f"thigh_{side}", KNEE, 0.06)),
            (arm_part(arm), bend(f"forearm_{side}", f"arm_{side}", ELBOW, 0.05)),
            (shoe_part(leg), stiff(f"foot_{side}")),
            (ellipsoid((arm, -0.005, 0.84), (0.032, 0.042, 0.075), 4, 8, SKIN), stiff(f"forearm_{side}")),
        ]
    return pairs


def make_armature():
    armature = bpy.data.objects.new("walker", bpy.data.armatures.new("walker"))
    bpy.context.scene.collection.objects.link(armature)
    bpy.context.view_layer.objects.active = armature
    bpy.ops.object.mode_set(mode="EDIT")
    for name, (parent, foot, tip) in BONES.items():
        bone = armature.data.edit_bones.new(name)
        bone.head, bone.tail = foot, tip
        bone.parent = armature.data.edit_bones[parent] if parent else None
    bpy.ops.object.mode_set(mode="OBJECT")
    return armature


def dress(armature, pairs, materials):
    """The mesh, bound to the bones."""
    mesh_object = make_object("walker_body", [part for part, _ in pairs], materials, 50.0)
    groups = {name: mesh_object.vertex_groups.new(name=name) for name in BONES}
    number = 0
    for part, weigh in pairs:
        for vertex in part.vertices:
            for bone, weight in weigh(vertex).items():
                if weight > 0.0:
                    groups[bone].add([number], weight, "REPLACE")
            number += 1
    mesh_object.parent = armature
    mesh_object.modifiers.new("armature", "ARMATURE").object = armature


def leg_angles(phase):
    """Forward turn of the thigh and bend of the knee, radians; the leg swings forward while the phase is near 0."""
    thigh = math.radians(4.0 + 25.0 * math.sin(phase))
    lift = max(0.0, math.cos(phase + 0.35))
    return thigh, math.radians(6.0 + 52.0 * lift * lift)


def leg_reach(phase):
    thigh, knee = leg_angles(phase)
    return (HIP - KNEE) * math.cos(thigh) + (KNEE - ANKLE) * math.cos(thigh - knee)


def pose_turns(phase):
    """Of each bone: its turn about the x axis (positive: backwards for what hangs) and about the z axis, radians."""
    swing = math.sin(phase)
    turns = {"hips": (0.0, 0.07 * swing), "spine": (0.05, -0.17 * swing), "head": (-0.03, 0.1 * swing)}
    for side, own in (("left", phase), ("right", phase + math.pi)):
        thigh, knee = leg_angles(own)
        toe_off = math.radians(22.0) * max(0.0, math.cos(own + 1.6)) ** 2
        turns[f"thigh_{side}"] = (-thigh, 0.0)
        turns[f"shin_{side}"] = (knee, 0.0)
        turns[f"foot_{side}"] = (0.9 * (thigh - knee) + toe_off, 0.0)
        turns[f"arm_{side}"] = (math.radians(24.0) * math.sin(own) + 0.02, 0.0)
        turns[f"forearm_{side}"] = (-math.radians(22.0 - 12.0 * math.sin(own)), 0.0)
    return turns


def set_pose(armature, phase):
    """Turns are about the axes of the model, whichever way a bone's own axes lie."""
    for name, (about_x, about_z) in pose_turns(phase).items():
        bone = armature.pose.bones[name]
        rest = bone.bone.matrix_local.to_quaternion()
        turn = Quaternion((0, 0, 1), about_z) @ Quaternion((1, 0, 0), about_x)
        bone.rotation_quaternion = rest.inverted() @ turn @ rest
    hips = armature.pose.bones["hips"]
    sink = max(leg_reach(phase), leg_reach(phase + math.pi)) - (HIP - ANKLE)
    hips.location = hips.bone.matrix_local.to_3x3().inverted() @ Matrix.Translation((0, 0, sink)).translation


def animate(armature):
    scene = bpy.context.scene
    scene.render.fps = FRAMES
    scene.frame_start, scene.frame_end = 0, FRAMES
    armature.animation_data_create().action = bpy.data.actions.new("walk")
    for frame in range(FRAMES + 1):
        set_pose(armature, math.tau * (frame % FRAMES) / FRAMES)
        for bone in armature.pose.bones:
            bone.keyframe_insert("rotation_quaternion", frame=frame)
        armature.pose.bones["hips"].keyframe_insert("location", frame=frame)


def build():
    materials = [
        make_material("tunic", "#35627e", 0.9),
        make_material("skin", "#b98a63", 0.8),
        make_material("trousers", "#6b5844", 0.9),
        make_material("straw", "#d8b566", 0.9),
    ]
    armature = make_armature()
    dress(armature, body(), materials)
    animate(armature)
