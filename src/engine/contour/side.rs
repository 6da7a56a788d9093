//! A block with G132 or G133 (execution of contours, 4 and 6; E100L-CGS-01 to E100L-CGS-07).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{
    AlarmName, ContourPlane, Length, RuleSet, Sense, SideArc, SidePlane, Sink,
};

use crate::engine::Interpreter;
use crate::engine::arithmetic::contour::Spot;
use crate::engine::arithmetic::frame::coordinate;
use crate::engine::arithmetic::turn;
use crate::engine::cite;
use crate::engine::exact::{Formula, Real, round};
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};
use crate::engine::state::{C, X, Z};
use crate::engine::words::{Address, Words};

use super::arc::Arc;
use super::chord::Chord;
use super::motion::{Leg, Shape, word_cites};
use super::sense;

/// How far C may be wound, in micro-degrees: 5965 turns (E100L-CGS-06).
const MOST_WOUND: i128 = 5965 * 360_000_000;

/// π X C / 360 degrees: the length of a turn on the cylinder of a diameter.
pub struct Surface {
    pub diameter: i64,
    pub turn: i64,
}

impl Formula for Surface {
    fn value<R: Real>(&self, precision: R::Precision) -> R {
        let turned = i128::from(self.diameter) * i128::from(self.turn);
        let around = R::integer(turned, precision).times(&R::pi(precision));
        around.over(&R::integer(turn::TURN.into(), precision))
    }
}

impl Interpreter<'_> {
    /// A contour block on the side.
    pub(super) fn side_contour(
        &mut self,
        words: &Words,
        motion: u16,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        self.check_c_axis(CAX_02, CAX_07)?;
        let incremental = self.state.incremental;
        let [x, z, c] = [X, Z, C].map(|axis| self.state.program(axis));
        let target = |address, present| words.get(address).map(|word| coordinate(present, word, incremental));
        if target(Address::X, x).is_some_and(|target| target != x) {
            return Fault::raise(AlarmName::ContourXChanged, CGS_03);
        }
        if x <= 0 {
            return Fault::raise(AlarmName::ContourXNotPositive, CGS_01);
        }
        let end_c = target(Address::C, c).map_or(c, turn::within);
        let end_z = target(Address::Z, z);
        let travel = turn::travel(c, end_c, 0, self.state.c_negative);
        let shape = self.side_arc(words, motion, (x, travel), (z, end_z.unwrap_or(z)))?;
        self.check_wound(travel)?;
        end_z.map_or(Ok(()), |z| self.check_coordinate(z))?;
        let feed = self.feed()?;
        self.check_no_barrier(CGS_01)?;
        let rules = self.side_rules(words);
        let cites = word_cites(&self.state, self.inch_block, words.has(Address::X))
            .and(self.feed_cites())
            .and_if(words.has(Address::C), cite::CAX_05);
        let leg = Leg { shape, face: None, z: end_z, c: end_c, travel, feed, part: None, rules };
        self.follow_contour(&leg, cites, sink)
    }

    /// The rules of a side block.
    pub(in crate::engine) fn side_rules(&self, words: &Words) -> RuleSet {
        let mut rules = const { RuleSet::of(&[CGS_01, CGS_02, CGS_04]) };
        for (holds, rule) in
            [(words.has(Address::C), CGS_05), (self.setup.parameters.side_contour_mode, CGS_07)]
        {
            if holds {
                rules = rules.with(rule);
            }
        }
        rules
    }

    /// C is not wound too far by a travel.
    pub(in crate::engine) fn check_wound(&self, travel: i64) -> Result<(), Fault> {
        if (self.state.contour.wound + i128::from(travel)).abs() > MOST_WOUND {
            return Fault::raise(AlarmName::ProfileGeneration, CGS_06);
        }
        Ok(())
    }

    /// The arc on the cylinder of a diameter, by a travel of C, between two places along Z.
    fn side_arc(
        &mut self,
        words: &Words,
        motion: u16,
        (diameter, travel): (i64, i64),
        (from, to): (i64, i64),
    ) -> Result<Shape, Fault> {
        let sense = sense(motion);
        let around = round(&Surface { diameter, turn: travel }, &mut self.slow);
        let inner = self.is_seen_from_inside();
        // Seen from inside the developed surface is mirrored.
        let seen = |around: i64| if inner { around.saturating_neg() } else { around };
        let ends = (Spot { p: 0, q: from }, Spot { p: seen(around), q: to });
        let radius = words.get(Address::L).unwrap_or_default();
        let centre = self.side_centre(ends, (diameter, travel), radius, sense)?;
        let side =
            SideArc { travel: Length(around), centre: Length(seen(centre.p)), centre_z: Length(centre.q) };
        Ok(Shape::Arc(sense, ContourPlane::SideArc(side)))
    }

    /// Whether the developed surface is seen from inside (E100L-CGS-02).
    pub(in crate::engine) fn is_seen_from_inside(&self) -> bool {
        self.setup.parameters.side_plane == SidePlane::Inner && !planted::is(Bug::InnerPlaneIgnored)
    }

    /// The centre of an arc between two points of the side plane with a radius, latched; they are a travel of C on the
    /// cylinder of a diameter apart.
    pub(in crate::engine) fn side_centre(
        &mut self,
        (start, end): (Spot, Spot),
        (diameter, travel): (i64, i64),
        radius: i64,
        sense: Sense,
    ) -> Result<Spot, Fault> {
        let chord = Chord::on_side(diameter, travel, end.q.saturating_sub(start.q));
        Arc { start, end, chord, radius, sense, rule: CGS_04 }.centre(&mut self.slow)
    }
}
