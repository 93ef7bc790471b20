"""The pictures, by kind: each function returns a lab.draw.Picture, or None where there is nothing to draw."""
