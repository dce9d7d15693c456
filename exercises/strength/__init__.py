"""Strength of materials: tension, torsion, bending, stress states."""
