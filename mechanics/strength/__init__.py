"""Strength of materials: stress and strain, bars, beams, shafts, sections."""
