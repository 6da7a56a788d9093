//! Where in a program text an event comes from.

use serde::{Deserialize, Serialize};

use super::Label;

/// A block of the program.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Place {
    /// Program name with its `O`, empty for a program without one.
    #[serde(default, skip_serializing_if = "Label::is_empty")]
    pub program: Label,
    /// Sequence name with its `N`, empty for a block without one.
    #[serde(default, skip_serializing_if = "Label::is_empty")]
    pub sequence: Label,
    /// Number of the block's first line, from 1.
    pub line: u32,
    /// Offset of the block's first byte.
    pub start: u32,
    /// Offset after the block's last byte; the end of block does not count.
    pub end: u32,
}
