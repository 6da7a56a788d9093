//! Drawings of a run: the path of the tool in the plane of Z and X, as a lathe drawing has it.
//!
//! The path is that of the trace, in the program coordinates in force at each motion, X as a radius, at one scale for
//! both axes. In radius compensation it is the path of the tip, and the programmed contour is drawn beside it.
//! Of a call of LAP contour and blank are drawn, as its definition has them.

mod axes;
mod html;
mod legend;
mod outline;
mod path;
mod sheet;
mod view;

pub use html::{Told, page};
pub use outline::Definition;
pub use path::{Kind, Plan, Segment};
pub use sheet::svg;
pub use view::Extent;
