//! turnspec-conformance.
