"""The drawing vocabulary: machines, beams and shafts as SVG."""
