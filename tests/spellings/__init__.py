"""Right answers as many hands write them, and wrong ones: made without the printer and parser they are read by."""
