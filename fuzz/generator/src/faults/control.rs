//! Faults of control flow that need programs, modes or a set-up.

use turnspec_oracle::vocabulary::{Feature, Label};

use super::Fault;
use crate::builder::Builder;

/// How many local variables may be registered.
const CAPACITY: usize = 127;

impl Builder<'_, '_, '_> {
    /// Adds blocks with this fault.
    pub(super) fn control_fault(&mut self, fault: Fault) -> bool {
        let level = self.state.setup.options.user_task;
        let names = self.allows(Feature::Subprogram) && self.allows(Feature::ProgramName);
        let calls = level == 2 && names;
        match fault {
            Fault::ProgramDuplicate if calls => self.duplicate_program(),
            Fault::CallDepth if calls => self.too_deep(),
            Fault::NoReturn if calls => self.without_return(),
            Fault::ModinDepth if calls => self.nine_modes(),
            Fault::ReturnOutsideSubprogram | Fault::ModoutWithoutModin if !calls => false,
            Fault::ReturnOutsideSubprogram if self.state.control.is_called() => false,
            Fault::ModoutWithoutModin if self.state.control.has_modes() => false,
            Fault::MacroUnassigned | Fault::ProgramUnknown if !calls => false,
            Fault::ProgramUnknown if self.choices.chance(30) => self.unknown_macro(),
            Fault::ProgramUnknown if self.choices.chance(20) => self.only_nearly_known(),
            Fault::StepLimit => self.too_many_steps(),
            Fault::LocalUndefined if calls && self.choices.chance(30) => self.no_longer_defined(),
            Fault::LocalCapacity => self.too_many_locals(),
            Fault::UserTaskLevel if level == 2 => false,
            Fault::SequenceNameUnknown if calls && self.choices.chance(30) => self.name_of_another_program(),
            Fault::ProgramNameMalformed | Fault::ProgramNameReserved => {
                calls && self.choices.chance(40) && self.called_by_a_wrong_name(fault)
            }
            Fault::Unspecified if calls && self.choices.chance(35) => self.not_described_of_modes(),
            Fault::Unspecified if self.choices.chance(20) => self.statement_behind_a_corner(),
            Fault::AngleLookahead if self.choices.chance(35) => self.statement_behind_a_corner(),
            _ => false,
        }
    }

    /// A block that calls a program by one of the statements, or by a macro code.
    fn call_of(&mut self, name: &str) -> bool {
        let text = self.choices.weighted(&[(60, "CALL"), (20, "NC7 CALL"), (20, "M")]);
        if text != "M" {
            return self.blocks(&[&format!("{text} O{name}")]);
        }
        let number = self.choices.within(341, 360);
        self.state.setup.macros.insert(format!("M{number}"), Label::new(&format!("O{name}")));
        self.blocks(&[&format!("M{number}")])
    }

    /// Two programs of one name, or one with the name of the main program.
    fn duplicate_program(&mut self) -> bool {
        let main = self.state.control.main_name();
        let name = match main {
            Some(name) if self.choices.chance(30) => name,
            _ => self.raw_program(&["M65", "RTS"]),
        };
        self.named_program(name.clone(), &["RTS"]);
        if self.choices.chance(20) {
            return self.blocks(&[&format!("MODIN O{name}")]);
        }
        self.call_of(&name)
    }

    /// Programs within each other: one that calls itself, the main program, a modal call at the bottom.
    fn too_deep(&mut self) -> bool {
        let main = self.state.control.main_name();
        match (self.choices.below(4), main) {
            (0, Some(name)) => self.call_of(&name),
            (1, _) if !self.state.is_eia() => {
                let still = self.raw_program(&["M65", "RTS"]);
                let most = usize::from(self.state.setup.parameters.call_depth);
                let left = most.saturating_sub(self.state.control.calls());
                let name = self.new_program_name();
                let lines = [
                    "V199=V199+1".to_owned(),
                    format!("IF[V199 GE {left}] N1"),
                    format!("CALL O{name}"),
                    "N1 G91 G00 X0 Z0".to_owned(),
                    "RTS".to_owned(),
                ];
                self.named_program(name.clone(), &lines.each_ref().map(String::as_str));
                self.blocks(&[&format!("MODIN O{still}"), "V199=0", &format!("CALL O{name}")])
            }
            _ => {
                let name = self.new_program_name();
                self.named_program(name.clone(), &[&format!("CALL O{name}"), "RTS"]);
                if self.choices.chance(30) {
                    return self.blocks(&[&format!("MODIN O{name}"), "G91 G00 X0 Z0"]);
                }
                self.call_of(&name)
            }
        }
    }

    /// A program that runs to its end.
    fn without_return(&mut self) -> bool {
        let lists: [&[&str]; 7] = [
            &["M65"],
            &[],
            &["GOTO N1", "RTS", "N1 M08"],
            &["M08", "OTOOLONG1 (A)", "RTS"],
            &["M65", "N2", "%"],
            &["/RTS X", "/"],
            &["(RTS)"],
        ];
        let lines = self.choices.pick(&lists);
        let name = self.raw_program(lines);
        if self.choices.chance(25) {
            return self.blocks(&[&format!("MODIN O{name}"), "G91 G00 X0"]);
        }
        self.call_of(&name)
    }

    fn nine_modes(&mut self) -> bool {
        let name = self.raw_program(&["RTS"]);
        let line = format!("MODIN O{name}");
        let lines: Vec<&str> = std::iter::repeat_n(line.as_str(), 9).collect();
        self.blocks(&lines)
    }

    fn unknown_macro(&mut self) -> bool {
        let (letter, number) =
            self.choices.pick(&[('G', 206), ('G', 171), ('M', 322), ('M', 355), ('G', 162)]);
        self.state.setup.macros.insert(format!("{letter}{number}"), Label::new("O404"));
        self.blocks(&[&format!("{letter}{number}")])
    }

    /// A name that is another one as text, or stands in a name block with a fault.
    fn only_nearly_known(&mut self) -> bool {
        let (given, called) =
            self.choices.pick(&[("0404", "404"), ("404", "0404"), ("4040X", "4040"), ("XYZAB", "XYZA")]);
        self.named_program(given.to_owned(), &["RTS"]);
        self.blocks(&[&format!("CALL O{called}")])
    }

    fn called_by_a_wrong_name(&mut self, fault: Fault) -> bool {
        let reserved = fault == Fault::ProgramNameReserved;
        let text = if reserved {
            "CALL OO1"
        } else {
            self.choices.pick(&["CALL O1A AB=5", "MODIN O12345", "CALL O"])
        };
        let name = self.raw_program(&[text, "RTS"]);
        self.call_of(&name)
    }

    /// A loop without end, or a limit that is soon reached.
    fn too_many_steps(&mut self) -> bool {
        if !self.allows(Feature::ControlStatement) {
            return false;
        }
        self.state.setup.limits.steps = self.choices.within(1, 120).unsigned_abs();
        let lists: [&[&str]; 5] = [
            &["NZ99 GOTO NZ99"],
            &["NZ99", "", "GOTO NZ99"],
            &["NZ99 M65", "(A)", "/GOTO NZ99", "GOTO NZ99"],
            &["NZ99 IF[1] NZ99"],
            &["GOTO NZ99", "M02", "NZ99", "GOTO NZ99"],
        ];
        let lines = self.choices.pick(&lists);
        self.blocks(lines)
    }

    /// A local variable of a program that has ended, or of a mode that has.
    fn no_longer_defined(&mut self) -> bool {
        let name = self.raw_program(&["TMP=5", "V1=TMP+ARGX", "RTS"]);
        let still = self.raw_program(&["RTS"]);
        match self.choices.below(3) {
            0 => self.blocks(&[&format!("CALL O{name} ARGX=1"), "V1=TMP"]),
            1 => self.blocks(&[&format!("CALL O{name} ARGX=1"), "V1=ARGX"]),
            _ => self.blocks(&[&format!("MODIN O{still} ARGX=1"), "V1=ARGX", "MODOUT", "V1=ARGX"]),
        }
    }

    /// More local variables than may be registered, the last one by one of the statements.
    fn too_many_locals(&mut self) -> bool {
        let names = (0..=CAPACITY).map(|number| {
            let letter = char::from(b'C' + u8::try_from(number / 10).unwrap_or_default());
            format!("D{letter}{}=1", number % 10)
        });
        let names: Vec<String> = names.collect();
        let lines: Vec<String> = names.chunks(12).map(|names| names.join(" ")).collect();
        let mut lines: Vec<&str> = lines.iter().map(String::as_str).collect();
        if self.choices.chance(50) {
            let all = lines.len();
            lines.truncate(all - self.choices.within(1, 2) as usize);
            let last = ["NOEX", "CALL O404", "MODIN O404"];
            let last = self.choices.pick(&last);
            let text: Vec<String> =
                (0..24).map(|number| format!("P{}Q=1", char::from(b'A' + number))).collect();
            let text = format!("{last} {}", text.join(" "));
            return self.blocks(&lines) && self.blocks(&[&text]);
        }
        self.blocks(&lines)
    }

    /// A block that another program has.
    fn name_of_another_program(&mut self) -> bool {
        let own = self.blocks(&["NM77 M65"]);
        let name = self.raw_program(&["GOTO NM77", "RTS"]);
        let there = self.raw_program(&["NS77 M65", "RTS"]);
        match self.choices.below(2) {
            0 => own && self.call_of(&name),
            _ => self.call_of(&there) && self.blocks(&["GOTO NS77"]),
        }
    }

    /// What the manual says nothing of about modal calls.
    fn not_described_of_modes(&mut self) -> bool {
        let still = self.raw_program(&["RTS"]);
        let begin = format!("MODIN O{still}");
        match self.choices.below(6) {
            0 => {
                let name = self.raw_program(&[&begin, "RTS"]);
                self.call_of(&name)
            }
            1 => {
                let name = self.raw_program(&[&begin, "MODOUT", "RTS"]);
                self.blocks(&[&format!("MODIN O{name}"), "G91 G00 X0"])
            }
            2 | 5 => {
                let name = self.raw_program(&["MODOUT", "RTS"]);
                self.blocks(&[&begin]) && self.call_of(&name)
            }
            3 => {
                let code = self.choices.within(75, 76);
                self.blocks(&[&begin, &format!("G91 G01 G{code} X50 L1 F1"), "Z9"])
            }
            _ => {
                let macros = self.raw_program(&["G161", "RTS"]);
                self.state.setup.macros.insert("G161".to_owned(), Label::new(&format!("O{still}")));
                self.blocks(&[&format!("MODIN O{macros}"), "G91 G00 Z0"])
            }
        }
    }

    /// A statement behind a block that needs the next one.
    fn statement_behind_a_corner(&mut self) -> bool {
        let corner = self.choices.pick(&["G91 G01 G75 X50 L1 F1", "G01 A30 F1", "G91 G01 G76 A10 L1 F1"]);
        let text = self.choices.pick(&[
            "GOTO N5",
            "IF[1] N5",
            "CALL O1",
            "RTS",
            "MODIN O1",
            "MODOUT",
            "G205",
            "M321 AB=1",
            "READ 0",
            "WRITE 0",
            "GET ,1",
            "PUT ,1",
        ]);
        let noex = self.choices.chance(20);
        self.blocks(&[corner, if noex { "NOEX AB=1" } else { text }])
    }
}
