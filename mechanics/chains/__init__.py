"""Serial chains: frames and tables, motion, drives, rod functional groups, accuracy."""
