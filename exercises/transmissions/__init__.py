"""Transmissions: gear trains on fixed and on moving axes."""
