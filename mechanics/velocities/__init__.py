"""Velocities and accelerations of one rigid link, as they are found by drawing."""
