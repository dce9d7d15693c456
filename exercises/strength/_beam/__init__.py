"""What the beams of the chapter share: supports, loads and their lines. The underscore keeps it off the shelf."""
