"""Strength of materials: bars, shafts, beams, sections, stress and strain."""
