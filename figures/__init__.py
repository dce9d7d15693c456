"""The drawing vocabulary: machines, beams, gears and shafts as SVG text.

A figure is a function of the numbers and words it is given. Points are complex numbers in user units, x to the
right and y up as in mechanics; angles are radians counter-clockwise from x. The canvas turns y over as it writes.
"""
