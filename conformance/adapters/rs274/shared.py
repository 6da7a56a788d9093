"""What is not shared by the two controls, as an exception of its own."""


class NotShared(Exception):
    """The program, or the machine, needs something that rs274 does not have or means otherwise."""
