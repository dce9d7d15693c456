"""Gears, screws, joints and Geneva drives."""
