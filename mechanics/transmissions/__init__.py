"""Transmissions: gears, screws, joints between shafts, the Geneva drive."""
