"""What make_scenes.py builds the scenes with: a glTF writer, a PNG writer, shapes and colours."""
