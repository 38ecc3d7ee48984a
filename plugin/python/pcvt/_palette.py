"""Colours that all pictures of pcvt share."""

# Faces with three to nine sides: pale at six, darker with the distance from six.
SIDES = ["#14215c", "#255fb0", "#62b0df", "#f3efe4", "#f2a23c", "#cb4b1e", "#701518"]
PALE = SIDES[3]
