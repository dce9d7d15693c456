"""Dynamics: inertia forces, reactions, drives, reduction of a machine to one link."""
