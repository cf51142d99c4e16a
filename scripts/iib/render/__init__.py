"""Photographs and films of scenes: surfaces by run_scene, light by Blender."""
