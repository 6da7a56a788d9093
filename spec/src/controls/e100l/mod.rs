//! Okuma OSP-E100L.

pub mod addresses;
pub mod g_codes;
pub mod m_codes;
pub mod macros;
pub mod system_variables;
pub mod tape_codes;
pub mod units;
