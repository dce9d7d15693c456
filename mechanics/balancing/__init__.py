"""Balancing of rotors and linkages, and the vibration of one mass."""
