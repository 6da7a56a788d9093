//! Faults of statements and of names, as texts (E100L-CTL-02 and -03, E100L-LVAR-01 and the rules of each statement).

use super::Fault;

/// Blocks that raise an alarm wherever they stand.
#[rustfmt::skip]
pub(super) const STATEMENTS: &[(Fault, &[&str])] = &[
    (Fault::ProgramKind, &["$A.SUB%", "$SHAFT-1.SSB%", "$X.Y.SUB% "]),
    (Fault::StatementMisplaced, &[
        "G00 GOTO N5", "X5 IF[V1 EQ 1] N1", "M08 END", "M08 RTS X5", "X5 G205", "M08 M321", "G00 G161 X1",
        "V1=5 CALL O1", "M65 NOEX", "NOEX AB=1 NOEX", "CALL O1 RTS", "X5 M=341", "G=205+0", "M08 G=171", "(A) X5 MODOUT",
        "G205 G205", "M321 M322", "V1=GOTO 5 CALL", "NOEX G161", "AB=1 MODIN O1", "X5 VSET V1=1", "M=300+21", "G=[161]",
        "X5 READ 1", "V1=5 PUT 'A'", "G00 GET V1,2", "(A) X5 WRITE 0", "VUACM[1]='A' END", "M08 PSELECT A",
    ]),
    (Fault::StatementDelimiterMissing, &[
        "GOTO1 N5", "GOTON5", "CALLO1", "CALL(A)O1AB=5", "RTS=5", "MODINO1", "MODOUT1", "NOEXAB=5", "READ1", "WRITE5",
        "GETAB", "IF ABC=5 N1", "IF[1]GOTON5", "IFABC N1", "IF ABC[1] N1", "CALL O1=5", "MODIN O12-3", "RTS5X", "RTS/",
        "NOEX=1", "CALL+O1", "IF AB/N1", "GOTO-N5", "PUT5AB", "GET,1", "PUT,1", "PUT'A'", "PUT$41", "RTS.", "IF XY$1 N2", "CALL O1/ AB=5",
    ]),
    (Fault::Format, &[
        "GOTO 5", "GOTO", "GOTO X5", "GOTO N5 X5", "GOTO N5 (A) 5", "IF", "IF 5 N1", "IF[1 EQ 1]", "IF[1]5", "IF V1 N5",
        "IF SIN N5", "IF EQ N5", "IF SB N1", "IF CALRG N1", "IF X N1", "IF GOTO N5", "CALL", "CALL 1", "CALL :1",
        "CALL X5", "MODIN", "MODIN N1", "MODIN 1", "MODIN X5", "MODIN AB", "MODIN AB=1", "RTS X5", "RTS RTS", "MODOUT 1", "MODOUT O1", "MODOUT X5", "MODOUT AB=1", "MODOUT M08", "MODOUT 7",
        "IF[1] GOTO 5", "IF[1] N1 GOTO N2",
        "IF[] N5", "GOTO N5 GOTO N6", "RTS (A) M02", "IF Q5 N1", "IF ABC GOTO X1", "CALL O1 5", "NOEX 5", "G205 5",
        "CALL O1 [AB]", "M321=321=5", "RTS%", "CALL O1 AB=SB", "IF[1]", "IF ABC",
    ]),
    (Fault::ProgramNameMalformed, &["CALL O1A", "MODIN O12345", "CALL O", "CALL O-1", "MODIN O 1", "G65\nCALL OABCDE AB=1"]),
    (Fault::ProgramNameReserved, &["CALL OO1", "MODIN OOX"]),
    (Fault::SequenceNameMalformed, &["GOTO N", "IF[1] N-5", "GOTO N(A)", "IF ABC N"]),
    (Fault::SequenceDelimiterMissing, &["GOTO N1A", "GOTO N123456", "IF[1] N5/", "GOTO N5=1", "GOTO N5X5", "IF[1]N5[2]"]),
    (Fault::WordWithoutFunction, &[
        "CALL O1 X5", "CALL O1 AB=5 CALRG", "MODIN O1 M08", "NOEX X5", "NOEX AB=1 G00", "G205 Z=5", "G161X5", "M321 S5",
        "CALL O1 X5 J5", "M350 AB=1 F0.2", "G171 SB=5", "MODIN O1 V1=2 PZ=3",
    ]),
    (Fault::LocalNameMalformed, &[
        "ABCDE=1", "X=NAB", "V1=OAB", "V1=ABCDEFGHIJ", "IF NAB N1", "IF ABCDE N5", "CALL O1 ABCDE=1", "NOEX WIDTH=5",
        "IF OAB N5", "V1=[NX1]+2", "XPOS1=5", "X=SIN[OX]", "GOTO1=5", "AB=NOTX",
    ]),
    (Fault::EqualSignMissing, &["ABC", "ABC 5", "LC X5", "CALL O1 AB", "NOEX DIA1 5", "AB[1]=5", "G205 AB[1]"]),
    (Fault::SequenceNameUnknown, &[
        "GOTO NX99", "IF[1]NX98", "IF [1 EQ 1] GOTO NX97", "NX96 GOTO NY96", "IF [-0.5] NX95", "/GOTO NX94",
    ]),
    (Fault::ProgramUnknown, &["CALL O404", "MODIN O404", "CALL O0404 AB=1 CD=AB", "MODIN OXYZ V1=5"]),
    (Fault::LocalUndefined, &[
        "X=ZZZ", "V1=ZZ1+1", "ZZ2=ZZ2+1", "CALL O404 BBX=CCX", "IF[UND EQ 1] N1", "G00 X5 Z=UND", "NOEX AB=UND",
        "V1=VTOFX[UND]", "F=UND M08", "VTOFX[UND]=1", "MODIN O404 ZZ3=ZZ4", "G205 BBX=BBY", "V1=0*UND", "M=UND",
    ]),
    (Fault::UserTaskLevel, &[
        "CALL O1", "RTS", "MODIN O1", "MODOUT", "CALL O1 AB=1/0", "G161", "G171 AB=UND", "M321", "M360", "MODIN O404",
    ]),
    (Fault::ReturnOutsideSubprogram, &["RTS", "NR5 RTS", "/RTS", "/NR6 RTS (A)"]),
    (Fault::ModoutWithoutModin, &["MODOUT", "NM5 MODOUT (A)"]),
    (Fault::MacroUnassigned, &["G161", "G170 AB=1", "M=321", "M360 V1=5", "G=214", "M0325", "G 2 0 5", "M 341"]),
];

/// Whether a text begins with a statement, in front of which nothing may stand.
pub(super) fn is_statement(text: &str) -> bool {
    const BEGINNINGS: &[&str] = &[
        "GOTO", "IF", "CALL", "RTS", "MOD", "NOEX", "READ", "WRITE", "GET", "PUT", "PSELECT", "VSET", "END",
    ];
    let code = |first: &str, rest: fn(&str) -> bool| text.strip_prefix(first).is_some_and(rest);
    let digits = |rest: &str| rest.trim_start_matches(['=', ' ', '0']).starts_with(['1', '2', '3']);
    BEGINNINGS.iter().any(|beginning| text.starts_with(beginning)) || code("G", digits) || code("M", digits)
}
