"""Linkages: position, velocity and acceleration of planar mechanisms."""
