"""What a set-up says to thread cutting."""
from fractions import Fraction as Q

from events import Unsupported

KNOWN = {
    None: {"control", "start", "zero_offset", "limits", "parameters", "readings", "unit_system"},
    "parameters": {"chamfering", "thread_chamfer_feed", "m75_pattern"},
    "readings": {"taper_reference", "thread_shift", "thread_flank", "balanced_infeed", "feed_length", "speed_clamp"},
    "limits": {"x", "z", "steps"},
    "start": {"x", "z"},
    "zero_offset": {"x", "z"},
}
#: What a written 1 means.
UNITS = {"1mm": Q(1), "10um": Q(1, 100), "1um": Q(1, 1000)}
#: The rate of withdrawal for a parameter of 1.
MM_PER_MINUTE = Q("4.6875")


class ThreadSetup:
    def __init__(self, table):
        for name, known in KNOWN.items():
            if set(table if name is None else table.get(name, {})) - known:
                raise Unsupported("set-up")
        self.unit = UNITS.get(table.get("unit_system", "1mm"))
        if self.unit is None:
            raise Unsupported("inch")
        parameters, readings = table.get("parameters", {}), table.get("readings", {})
        self.start, self.zero = (pair_of(table.get(name, {})) for name in ("start", "zero_offset"))
        self.table = table.get("limits", {})
        self.steps = self.table.get("steps", 10_000_000)
        self.withdrawal = MM_PER_MINUTE * parameters.get("thread_chamfer_feed", 640)
        self.any_angle = parameters.get("chamfering", "any_angle") == "any_angle"
        self.m75_pattern = parameters.get("m75_pattern", 3)
        self.k = Q(1) if readings.get("feed_length") == "diameter" else Q(1, 2)
        self.taper_from_start = readings.get("taper_reference") != "end"
        self.toward_end = readings.get("thread_shift") != "coordinate"
        self.flank_negative = readings.get("thread_flank") != "positive"
        self.equal_area = readings.get("balanced_infeed") == "equal_area"
        self.clamp_always = readings.get("speed_clamp") != "cutting_speed"

    def limits(self, axis):
        """The least and the greatest machine coordinate."""
        limits = self.table.get(axis, {})
        return tuple(Q(str(limits[side])) if side in limits else None for side in ("negative", "positive"))


def pair_of(table):
    """(x, z)"""
    return (Q(str(table.get("x", 0))), Q(str(table.get("z", 0))))
