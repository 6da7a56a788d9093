//! Calls of G85, G86 and G87 with contours that are composed: their programs, their mirrors, what the texts make of them.

use turnspec_generator::Case;
use turnspec_oracle::vocabulary::{AlarmName, Setup};

use crate::lap_plane::{Leg, Spot};
use crate::lap_shape::{Element, HALF, Way, end, legs, turns, turns_back};

/// What the code and the definition make of a call (E100L-LAP-22).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Mode {
    /// Mode I.
    Bar,
    /// Mode II.
    Copy,
    /// Mode IV.
    HighSpeed,
    /// Mode V.
    BarCopy,
}

/// Where a contour lies: its start on both axes in half micrometres of radius, and which way is up and forward.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Place {
    /// G82.
    pub(crate) across: bool,
    pub(crate) base: Way,
    /// The signs of height and run.
    pub(crate) up: i64,
    pub(crate) forward: i64,
}

/// A change point: how far below the AP start, and the depth behind it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Change {
    pub(crate) below: i64,
    pub(crate) step: i64,
}

/// A call. Ways count from the start of the contour, amounts are in half micrometres, on X as radii.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Job {
    pub(crate) mode: Mode,
    pub(crate) place: Place,
    pub(crate) contour: Vec<Element>,
    /// The first point of the blank, and its elements.
    pub(crate) blank: (Way, Vec<Element>),
    pub(crate) start: Way,
    pub(crate) step: i64,
    pub(crate) changes: Vec<Change>,
    pub(crate) allowance: Way,
    /// The first motion is in G01.
    pub(crate) at_feed: bool,
    /// M85.
    pub(crate) stays: bool,
    /// In micrometres, as the set-up has them.
    pub(crate) relief: u16,
    pub(crate) clearance: u32,
}

fn number(thousandths: i64) -> String {
    let sign = if thousandths < 0 { "-" } else { "" };
    let size = thousandths.unsigned_abs();
    format!("{sign}{}.{:03}", size / 1_000, size % 1_000)
}

impl Job {
    /// Half micrometres in an increment, by run and height: one on X, two on Z.
    pub(crate) fn increment(&self) -> Way {
        if self.place.across { Way { run: 1, height: 2 } } else { Way { run: 2, height: 1 } }
    }

    /// The letters of X and Z for height and run.
    fn letters(&self) -> (char, char) {
        if self.place.across { ('Z', 'X') } else { ('X', 'Z') }
    }

    /// A point in increments, as height and run have their axes.
    pub(crate) fn coordinates(&self, at: Way) -> Way {
        let (Way { run, height }, by) = (at.plus(self.place.base), self.increment());
        Way { run: self.place.forward * run / by.run, height: self.place.up * height / by.height }
    }

    /// The words of a point.
    fn words(&self, at: Way) -> String {
        let (Way { run, height }, (up, along)) = (self.coordinates(at), self.letters());
        format!("{up}{} {along}{}", number(height), number(run))
    }

    /// A point of a trace, X and Z in nanometres, by run and height.
    pub(crate) fn spot(&self, x: i64, z: i64) -> Spot {
        let (x, z) = (x as f64 / 2.0, z as f64);
        let (run, height) = if self.place.across { (x, z) } else { (z, x) };
        let (run, height) = (run * self.place.forward as f64, height * self.place.up as f64);
        Spot { run, height }.less(self.place.base.spot())
    }

    /// Whether senses are seen as they are, with run to the right and height up.
    pub(crate) fn keeps_sense(&self) -> bool {
        (self.place.up * self.place.forward > 0) != self.place.across
    }

    fn chain(&self, elements: &[Element], from: Way, text: &mut String) {
        let mut at = from;
        for element in elements {
            at = at.plus(element.way);
            let Some(arc) = element.arc else {
                *text += &format!("G01 {}\n", self.words(at));
                continue;
            };
            let code = if arc.over == self.keeps_sense() { "G02" } else { "G03" };
            let (height, run) =
                (self.place.up * arc.centre.height / 2, self.place.forward * arc.centre.run / 2);
            let (i, k) = if self.place.across { (run, height) } else { (height, run) };
            *text += &format!("{code} {} I{} K{}\n", self.words(at), number(i), number(k));
        }
    }

    /// The allowances as words.
    fn allowances(&self) -> String {
        let (Way { run, height }, by) = (self.allowance, self.increment());
        let (up, along) = if self.place.across { ("W", "U") } else { ("U", "W") };
        format!("{up}{} {along}{}", number(height / by.height), number(run / by.run))
    }

    fn program(&self, start: Way, call: &str) -> Case {
        let mut setup = Setup::default();
        (setup.parameters.lap_relief, setup.parameters.lap_clearance) = (self.relief, self.clearance);
        let code = if self.place.across { "G82" } else { "G81" };
        let first = if self.at_feed { "G01" } else { "G00" };
        let mut text = format!("F0.3\nG00 {}\n{call}\nM02\nNAT1 ", self.words(start));
        if self.has_blank() {
            text += &format!("G83\nG01 {}\n", self.words(self.blank.0));
            self.chain(&self.blank.1, self.blank.0, &mut text);
        }
        text += &format!("{code}\n{first} {}\n", self.words(Way::default()));
        self.chain(&self.contour, Way::default(), &mut text);
        text += "G80\n";
        Case { setup, program: text.into_bytes() }
    }

    /// The program of the rough cycle.
    pub(crate) fn case(&self) -> Case {
        let (by, (up, _)) = (self.increment().height, self.letters());
        let code = if matches!(self.mode, Mode::Copy | Mode::BarCopy) { "G86" } else { "G85" };
        let stays = if self.stays { " M85" } else { "" };
        let mut call = format!("{code} NAT1 D{} {}{stays}", number(self.step / by), self.allowances());
        for (change, letter) in self.changes.iter().zip(["A", "B"]) {
            let at = self.coordinates(self.start.less(Way { run: 0, height: change.below })).height;
            let head = if letter == "A" { " G84" } else { "" };
            call += &format!("{head} {up}{letter}={} D{letter}={}", number(at), number(change.step / by));
        }
        self.program(self.start, &call)
    }

    /// The program of the finish pass with the same contour and allowances, from an AP start in front of the contour.
    pub(crate) fn finishing(&self) -> Case {
        let apart = self.start.less(Way { run: 2, height: 0 });
        self.program(apart, &format!("G87 NAT1 {}", self.allowances()))
    }

    pub(crate) fn has_blank(&self) -> bool {
        matches!(self.mode, Mode::HighSpeed | Mode::BarCopy)
    }

    /// How far the rough contour is moved (E100L-LAP-21).
    pub(crate) fn shift(&self) -> Way {
        Way { run: -self.allowance.run, height: self.allowance.height }
    }

    /// The rough contour.
    pub(crate) fn rough(&self) -> Vec<Leg> {
        legs(self.shift(), &self.contour)
    }

    /// The elements of the blank from the start of the contour on: a line to its first point, its own, a line to the end of
    /// the contour (E100L-LAP-02).
    pub(crate) fn blank(&self) -> Vec<Element> {
        let (first, own) = &self.blank;
        let last = end(Way::default(), &self.contour).less(end(*first, own));
        let mut elements = vec![Element::line(first.run, first.height)];
        elements.extend(own);
        if last.run >= 0 {
            elements.push(Element::line(last.run, last.height));
        }
        elements.retain(|element| element.way != Way::default());
        elements
    }

    /// The depth below a level, from the AP start down (E100L-LAPC-03).
    pub(crate) fn depth_below(&self, level: i64) -> i64 {
        let reached = self.changes.iter().rev().find(|change| level <= self.start.height - change.below);
        reached.map_or(self.step, |change| change.step)
    }

    /// The least and the greatest of the depths.
    pub(crate) fn depths(&self) -> (i64, i64) {
        let depths = || self.changes.iter().map(|change| change.step).chain([self.step]);
        (depths().min().unwrap_or(1).max(1), depths().max().unwrap_or(1))
    }

    /// The length of a clearance along the run.
    pub(crate) fn clearance(&self) -> i64 {
        i64::from(self.clearance) * self.increment().run
    }

    /// The height of blank and rough contour together (E100L-AP4-01).
    pub(crate) fn highest(&self) -> i64 {
        let rough = turns(self.shift(), &self.contour);
        rough.into_iter().chain(turns(Way::default(), &self.blank())).max().unwrap_or(0)
    }

    /// Which alarm the texts let a call end with instead of passes.
    pub(crate) fn refusal(&self) -> Option<AlarmName> {
        let blank = self.blank();
        let descents = turns(self.shift(), &self.contour).windows(2).filter(|pair| pair[1] < pair[0]).count();
        let first = self.highest() - self.depth_below(self.highest());
        let near = self.shift().run - self.start.run < self.clearance();
        let slopes = matches!(self.mode, Mode::Bar | Mode::HighSpeed) && descents > 10;
        let beside = blank.first().is_some_and(|element| element.arc.is_some() && element.way.height > 0);
        match self.mode {
            Mode::HighSpeed if turns_back(&blank) => Some(AlarmName::Unspecified),
            Mode::BarCopy if turns_back(&blank) => Some(AlarmName::ContourDirection),
            Mode::BarCopy if self.allowance.run > self.clearance() => Some(AlarmName::LapAllowance),
            Mode::BarCopy if beside => Some(AlarmName::Unspecified),
            _ if slopes => Some(AlarmName::DescendingSlopes),
            Mode::HighSpeed if near && first > self.shift().height && first > self.start.height => {
                Some(AlarmName::Unspecified)
            }
            _ => None,
        }
    }

    /// The call in a mirror, by height (inside for outside) or by run.
    pub(crate) fn mirrored(&self, by_height: bool, by_run: bool) -> Self {
        let mut job = self.clone();
        job.place.up *= if by_height { -1 } else { 1 };
        job.place.forward *= if by_run { -1 } else { 1 };
        job
    }

    /// A half micrometre's multiple in nanometres.
    pub(crate) fn nanometres(amount: i64) -> f64 {
        amount as f64 * HALF
    }
}
