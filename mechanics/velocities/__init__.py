"""Velocities and accelerations of points of one link, and the plans that are drawn of them."""
