//! What the differential test and the long differential run share; either leaves a part unused.

pub mod campaign;
pub mod regression;
