"""Planar linkages: each in closed form, and any of them by Newton; mechanisms of a higher class."""
