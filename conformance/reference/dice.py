"""Random choices that a seed decides, the same on every machine and in every version of Python."""


class Dice:
    """SplitMix64."""

    def __init__(self, seed):
        self.state = seed

    def bits(self):
        self.state = (self.state + 0x9E3779B97F4A7C15) % 2**64
        value = self.state
        value = (value ^ (value >> 30)) * 0xBF58476D1CE4E5B9 % 2**64
        value = (value ^ (value >> 27)) * 0x94D049BB133111EB % 2**64
        return value ^ (value >> 31)

    def between(self, low, high):
        return low + self.bits() % (high - low + 1)

    def once_in(self, count):
        return self.bits() % count == 0

    def one_of(self, choices):
        return choices[self.bits() % len(choices)]

    def weighted(self, weights):
        at = self.bits() % sum(weights.values())
        for choice, weight in weights.items():
            if at < weight:
                return choice
            at -= weight
        raise AssertionError("the weights are used up")
